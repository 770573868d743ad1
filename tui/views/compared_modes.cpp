#include "tui/views/compared_modes.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/mac_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using updating::ModePair;

double ComparedMode::hz() const {
  return std::isfinite(measured_hz) ? measured_hz : model_hz;
}

std::vector<double> measured_hz(const CompareInput& input) {
  const updating::Comparison& c = input.comparison;
  std::vector<double> hz(static_cast<std::size_t>(c.mac.rows()), std::nan(""));
  const auto set = [&hz](std::size_t mode, double frequency) {
    if (mode < hz.size()) hz[mode] = frequency;
  };
  for (const ModePair& pair : c.pairs) {
    set(static_cast<std::size_t>(pair.measured), pair.measured_hz);
  }
  if (input.modes == nullptr) return hz;
  for (std::size_t i = 0; i < input.modes->modes.size(); ++i) {
    set(i, input.modes->modes[i].frequency_hz);
  }
  return hz;
}

std::vector<ComparedMode> compared_modes(const CompareInput& input) {
  const updating::Comparison& c = input.comparison;
  std::vector<ComparedMode> modes;
  for (const ModePair& pair : c.pairs) {
    modes.push_back({pair.measured_hz,
                     pair.model_hz,
                     pair.error_percent,
                     pair.has_shape ? pair.mac : std::nan("")});
  }
  const std::vector<double> measured = measured_hz(input);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const bool alone = std::ranges::none_of(c.pairs, [i](const ModePair& p) {
      return p.measured == static_cast<int>(i);
    });
    if (alone && std::isfinite(measured[i])) {
      modes.push_back({.measured_hz = measured[i]});
    }
  }
  FrequencySpan span = frequency_span(input.frfs);
  // Of modes that are the measurement, up to the highest.
  if (input.frfs.frfs.empty() && !measured.empty()) {
    span = {0.0, *std::ranges::max_element(measured)};
  }
  // Rigid-body modes that were not measured are no difference.
  const Eigen::Index rigid = rigid_modes(c.modes.frequency_hz);
  for (Eigen::Index k = rigid; k < c.modes.frequency_hz.size(); ++k) {
    const double hz = c.modes.frequency_hz[k];
    const bool alone = std::ranges::none_of(
        c.pairs, [k](const ModePair& p) { return p.model == k; });
    if (alone && hz >= span.lo && hz <= span.hi) {
      modes.push_back({.model_hz = hz});
    }
  }
  std::ranges::stable_sort(modes, {}, &ComparedMode::hz);
  return modes;
}

Table compared_table(const std::vector<ComparedMode>& modes) {
  Table table{{{"measured Hz", true},
               {"model Hz", true},
               {"error %", true},
               {"MAC", true}},
              {}};
  table.sortable = true;
  for (const ComparedMode& mode : modes) {
    Style style;
    if (!(mode.mac >= 0.9)) style.colour = Colour::Orange;
    table.rows.push_back({{fixed(mode.measured_hz, 3),
                           fixed(mode.model_hz, 3),
                           signed_words(mode.error_percent),
                           fixed(mode.mac, 3)},
                          style});
  }
  return table;
}

}  // namespace tapfit::tui
