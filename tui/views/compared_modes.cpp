#include "tui/views/compared_modes.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/mac_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace tapfit::tui {

using updating::Comparison;
using updating::ModePair;

namespace {

std::vector<std::string> pair_cells(const Comparison& c, int measured) {
  const auto pair = std::ranges::find(c.pairs, measured, &ModePair::measured);
  if (pair == c.pairs.end()) return {"–", "–", "–"};
  return {fixed(pair->model_hz, 3),
          signed_percent_words(pair->error_percent),
          pair->has_shape ? fixed(pair->mac, 3) : "–"};
}

}  // namespace

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

Table pair_table(const Comparison& before, const Comparison* after) {
  Table table{{{"measured Hz", true}}, {}};
  std::vector<const Comparison*> models{&before};
  if (after != nullptr) models.push_back(after);
  std::map<int, double> measured;
  for (const Comparison* c : models) {
    const char* which = after == nullptr ? "model Hz"
                        : c == &before   ? "before Hz"
                                         : "after Hz";
    for (const char* column : {which, "error", "MAC"}) {
      table.columns.push_back({column, true});
    }
    for (const ModePair& p : c->pairs) measured[p.measured] = p.measured_hz;
  }
  for (const auto& [mode, hz] : measured) {
    Row row{{fixed(hz, 3)}, {}};
    for (const Comparison* c : models) {
      std::ranges::move(pair_cells(*c, mode), std::back_inserter(row.cells));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string mean_error_words(const Comparison& c) {
  double sum = 0.0;
  for (const ModePair& pair : c.pairs) sum += std::abs(pair.error_percent);
  return fixed(sum / static_cast<double>(c.pairs.size()), 2) + " %";
}

}  // namespace tapfit::tui
