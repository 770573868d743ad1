#include "tui/report/report_model.hpp"

#include "tui/document/svg_heat_map.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/report/report_criteria.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "tui/widgets/signature_plot.hpp"
#include "updating/localisation/signature_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace tapfit::tui {
namespace {

using updating::Comparison;
using updating::ModePair;

bool anything_changed(const ModelResults& model) {
  return model.ladder.size() > 1;
}

/// The model's modes that a reader looks for: paired, before or after, or
/// between those measured. The same of both models, for one beside the other.
std::vector<Eigen::Index> shown_modes(const ReportData& data) {
  constexpr std::size_t most = 14;
  std::vector<Eigen::Index> shown;
  if (data.modes.modes.empty()) return shown;
  const double low = 0.7 * data.modes.modes.front().frequency_hz;
  const double high = 1.2 * data.modes.modes.back().frequency_hz;
  const std::array<const Comparison*, 2> models{&data.model->before,
                                                &data.model->after};
  const auto is_paired = [&](Eigen::Index mode) {
    return std::ranges::any_of(models, [mode](const Comparison* c) {
      return std::ranges::count(c->pairs, mode, &ModePair::model) > 0;
    });
  };
  const Eigen::Index count =
      std::min(models[0]->mac.cols(), models[1]->mac.cols());
  for (Eigen::Index k = 0; k < count; ++k) {
    const bool near = std::ranges::any_of(models, [&](const Comparison* c) {
      const double hz = c->modes.frequency_hz(k);
      return hz >= low && hz <= high;
    });
    if (is_paired(k) || near) shown.push_back(k);
  }
  // Those paired stay where there are too many.
  std::ranges::stable_partition(shown, is_paired);
  if (shown.size() > most) shown.resize(most);
  std::ranges::sort(shown);
  return shown;
}

Figure mac_figure(const ReportData& data,
                  const Comparison& comparison,
                  const char* name,
                  const char* title) {
  const std::vector<Eigen::Index> shown = shown_modes(data);
  SvgHeatMap map;
  map.name = title;
  map.values = comparison.mac(Eigen::all, shown);
  map.row_title = "measured Hz";
  map.column_title = "model Hz";
  for (const modal::Mode& mode : data.modes.modes) {
    map.rows.push_back(four_digits(mode.frequency_hz));
  }
  for (const Eigen::Index k : shown) {
    map.columns.push_back(four_digits(comparison.modes.frequency_hz(k)));
  }
  return {name, title, svg_heat_map(map)};
}

FigureRow mac_row(const ReportData& data) {
  const ModelResults& model = *data.model;
  const bool both = anything_changed(model);
  FigureRow row;
  row.figures.push_back(mac_figure(data,
                                   model.before,
                                   "mac-before",
                                   both ? "MAC in %, before" : "MAC in %"));
  if (both) {
    row.figures.push_back(
        mac_figure(data, model.after, "mac-after", "MAC in %, after"));
  }
  return row;
}

Section correlation_section(const ReportData& data) {
  Section section{"Correlation of model and measurement", criteria_parts(data)};
  const bool shapes = !data.modes.dofs.empty();
  if (shapes && data.model->before.mac.size() > 0 &&
      data.model->after.mac.size() > 0) {
    section.parts.emplace_back(mac_row(data));
  }
  return section;
}

/// The FRFs of the largest error before, in their own order.
std::vector<std::size_t> shown_frfs(const Comparison& before) {
  constexpr std::size_t most = 24;  // half a page
  std::vector<std::size_t> shown(before.frf_error.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  std::ranges::stable_sort(shown, [&](std::size_t a, std::size_t b) {
    return before.frf_error[a] > before.frf_error[b];
  });
  if (shown.size() > most) shown.resize(most);
  std::ranges::sort(shown);
  return shown;
}

Figure error_figure(const ReportData& data,
                    const Comparison& comparison,
                    double full,
                    const char* name_of_file,
                    const char* which) {
  SvgHeatMap map;
  map.name = fmt::format("error map, {}", which);
  map.alarming = true;
  map.full = full;
  map.row_title = "response / hammer";
  map.column_title = "band, up to Hz";
  const std::vector<std::size_t> shown = shown_frfs(data.model->before);
  map.values.resize(static_cast<Eigen::Index>(shown.size()),
                    comparison.frf_band_error.cols());
  for (std::size_t k = 0; k < shown.size(); ++k) {
    map.values.row(static_cast<Eigen::Index>(k)) =
        comparison.frf_band_error.row(static_cast<Eigen::Index>(shown[k]));
    map.rows.push_back(name(data.frfs.frfs.at(shown[k])));
  }
  for (const updating::BandError& band : comparison.bands) {
    map.columns.push_back(number(band.high_hz));
  }
  const std::size_t all = comparison.frf_error.size();
  return {name_of_file,
          fmt::format("Relative error of each FRF in each band [%], {}{}.",
                      which,
                      shown.size() < all
                          ? fmt::format("; the {} of {} with the largest error",
                                        shown.size(),
                                        all)
                          : ""),
          svg_heat_map(map)};
}

bool has_error_map(const ReportData& data, const Comparison& comparison) {
  const auto rows = static_cast<Eigen::Index>(comparison.frf_error.size());
  return rows > 0 && comparison.frf_band_error.rows() == rows &&
         comparison.frf_band_error.cols() > 0 &&
         comparison.frf_error.size() <= data.frfs.frfs.size();
}

Section error_section(const ReportData& data) {
  const ModelResults& model = *data.model;
  // On one scale what is small after would be blank.
  const auto full_of = [](const Comparison& c) {
    const double largest = (c.frf_band_error.array().isFinite())
                               .select(c.frf_band_error, 0.0)
                               .maxCoeff();
    return std::clamp(largest, 1e-9, 1.0);
  };
  FigureRow row;
  const bool both = anything_changed(model);
  row.figures.push_back(error_figure(data,
                                     model.before,
                                     full_of(model.before),
                                     "error-before",
                                     both ? "before" : "of the model"));
  if (both && has_error_map(data, model.after)) {
    row.figures.push_back(error_figure(data,
                                       model.after,
                                       full_of(model.after),
                                       "error-after",
                                       "after, on a scale of its own"));
  }
  return {"Where the error is", {row}};
}

bool found_absorber(const ModelResults& model, int node) {
  return std::ranges::any_of(model.ladder, [node](const updating::Rung& rung) {
    return rung.added == "absorber" && rung.where.node == node;
  });
}

/// Where one grid explains most of the misfit.
bool means_something(const std::optional<updating::Signature>& signature) {
  return signature && updating::is_significant(*signature) &&
         signature->frequency_hz.size() > 1 &&
         signature->z.size() == signature->frequency_hz.size();
}

/// What is beyond the range is a gap.
void leave_gaps(Plot& plot) {
  for (Curve& curve : plot.curves) {
    for (double& y : curve.y) {
      if (y < plot.y.lo || y > plot.y.hi) {
        y = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
}

Section signature_section(const ModelResults& model) {
  const updating::Signature& signature = *model.signature;
  const bool resonant = found_absorber(model, signature.node);
  const updating::SignatureLaw law = updating::best_law(signature, resonant);
  Plot plot = signature_plot(signature, {}, false, resonant);
  plot.title = fmt::format("missing stiffness at grid {}", signature.node);
  plot.x.label = "frequency";
  plot.y.label = "missing stiffness";
  plot.curves[0].label = "real part";
  plot.curves[0].pen = {Colour::Blue};
  plot.curves[1].label = "imaginary part";
  plot.curves[2].label =
      law_name(law) + (law.is_imaginary() ? " (imaginary)" : "");
  if (plot.y.lo < plot.y.hi) leave_gaps(plot);
  return {
      "The missing stiffness",
      {Figure{
          "signature",
          fmt::format(
              "Dynamic stiffness that the base model lacks at grid {0}. "
              "Grid {0} alone explains {1} of the misfit; {2} leaves {3} of "
              "it. A mass falls with frequency squared, a spring is "
              "constant, a dashpot is imaginary and rises, an absorber changes "
              "its sign at its own frequency.",
              signature.node,
              percent(signature.explained),
              law_name(law),
              percent(law.unexplained)),
          svg_plot(plot, {.height = 300.0})}}};
}

}  // namespace

std::vector<Section> model_sections(const ReportData& data) {
  if (!data.model) return {};
  std::vector<Section> sections;
  if (!data.modes.modes.empty()) sections.push_back(correlation_section(data));
  if (has_error_map(data, data.model->before)) {
    sections.push_back(error_section(data));
  }
  if (means_something(data.model->signature)) {
    sections.push_back(signature_section(*data.model));
  }
  return sections;
}

}  // namespace tapfit::tui
