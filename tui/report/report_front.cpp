#include "tui/report/report_front.hpp"

#include "tui/document/svg_bars.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/report/report_criteria.hpp"
#include "tui/report/report_evidence.hpp"
#include "tui/report/report_measurement.hpp"
#include "tui/report/report_parameters.hpp"
#include "tui/report/report_verdict.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "updating/fit/early_stopped_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

namespace tapfit::tui {
namespace {

using updating::Rung;

std::array<double, 2> band_of(const ReportData& data) {
  if (data.bundle.band_hz) return *data.bundle.band_hz;
  if (data.frfs.lines() == 0) return {0.0, 0.0};
  const Eigen::VectorXd hz = data.frfs.frequency_hz();
  return {hz(0), hz(hz.size() - 1)};
}

std::string hits_words(const acquisition::HitSet& hits) {
  std::size_t found = 0;
  long accepted = 0;
  for (const auto& run : hits.runs) {
    found += run.size();
    accepted += std::count_if(
        run.begin(), run.end(), [](const auto& hit) { return hit.accepted; });
  }
  return fmt::format("{} found, {} accepted", found, accepted);
}

/// "24 hit, 2 with sensors", of those that an FRF is from and at.
std::string points_words(const signal::FrfSet& frfs) {
  std::set<std::string> hit;
  std::set<std::string> measured;
  for (const signal::Frf& frf : frfs.frfs) {
    hit.insert(name(frf.reference));
    measured.insert(name(frf.response));
  }
  return fmt::format("{} hit, {} with sensors", hit.size(), measured.size());
}

/// One row: what a customer asks first, and whatever test.json says of it.
DataTable tested(const ReportData& data) {
  DataTable table{"What was tested", {}, {{}}};
  const auto add = [&](const std::string& what, const std::string& value) {
    if (value.empty()) return;
    table.heading.push_back(what);
    table.rows[0].push_back(value);
  };
  add("<bundle", data.path.lexically_normal().filename().string());
  if (data.model) add("<model", data.model->deck.path.filename().string());
  if (data.hits) {
    add("<runs", fmt::format("{}", data.bundle.runs.size()));
    add("<hits", hits_words(*data.hits));
  } else if (data.bundle.frfs) {
    add("<FRFs from", data.bundle.frfs->filename().string());
  }
  if (data.bundle.modes) {
    add("<modes from", data.bundle.modes->file.filename().string());
    add("<points", fmt::format("{}", data.modes.dofs.size()));
  } else {
    add("<points", points_words(data.frfs));
    add("<FRFs", fmt::format("{}", data.frfs.frfs.size()));
    const std::array<double, 2> band = band_of(data);
    add("<band", fmt::format("{} to {} Hz", number(band[0]), number(band[1])));
  }
  add("<modes", fmt::format("{}", data.modes.modes.size()));
  for (const auto& [what, value] : data.notes.facts) {
    add("<" + what, value);
  }
  return table;
}

/// A driving point where there is one: it has every mode.
std::size_t shown_frf(const signal::FrfSet& frfs) {
  for (std::size_t k = 0; k < frfs.frfs.size(); ++k) {
    const signal::Frf& frf = frfs.frfs[k];
    if (frf.response.node == frf.reference.node &&
        frf.response.component == frf.reference.component) {
      return k;
    }
  }
  return 0;
}

void add_model_curve(Plot& plot,
                     const updating::Comparison& comparison,
                     std::size_t frf,
                     const char* label,
                     const Pen& pen) {
  const Eigen::VectorXd& hz = plot.curves.front().x;
  if (frf >= comparison.model_frfs.size()) return;
  if (comparison.model_frfs[frf].size() != hz.size()) return;
  plot.curves.push_back(
      {label, hz, comparison.model_frfs[frf].cwiseAbs(), {}, {}, pen});
}

/// @param picture smaller where another stands beside it
Figure frf_figure(const ReportData& data, const Picture& picture) {
  const std::size_t shown = shown_frf(data.frfs);
  const signal::Frf& frf = data.frfs.frfs[shown];
  const Eigen::VectorXd hz = data.frfs.frequency_hz();
  Plot plot;
  plot.title = "FRF " + name(frf);
  plot.x = {"frequency", "Hz", 0.0, 0.0, false};
  plot.y = {"|H|", "(m/s²)/N", 0.0, 0.0, true};
  plot.curves = {{"measured", hz, frf.H.cwiseAbs(), {}, {}, {}}};
  std::string caption =
      fmt::format("Accelerance {} (response / hammer)", name(frf));
  if (data.model) {
    const bool changed = data.model->ladder.size() > 1;
    add_model_curve(plot,
                    data.model->before,
                    shown,
                    changed ? "model before" : "model",
                    {Colour::Orange, Pattern::Dashed});
    if (changed) {
      add_model_curve(plot,
                      data.model->after,
                      shown,
                      "model after",
                      {Colour::Blue, Pattern::Dotted});
    }
  }
  if (const double sigma = data.frfs.s(0).real(); sigma > 0.0) {
    caption += fmt::format(
        ", with the exponential window of {} 1/s on all curves", number(sigma));
  }
  return {"frf", caption + ".", svg_plot(plot, picture)};
}

std::string ladder_words(const Rung& rung) {
  if (rung.added == updating::base_rung) return "model as delivered";
  if (rung.added == updating::uncertain_rung) {
    return "uncertain properties identified";
  }
  return "+ " + found_words(rung.added, rung.where);
}

/// What the error is one of.
std::string error_words(const ReportData& data) {
  if (!data.bundle.modes) {
    return "Relative error of the FRFs after each step; each identifies all "
           "parameters anew. Floor: what the scatter over the hits, the mesh "
           "and the form of the model (what a careful model is wrong by) "
           "allow";
  }
  return "Error of the modes after each step: root mean square of all "
         "frequencies and shapes, each in units of its standard deviation, "
         "times that of the frequencies; each step identifies all parameters "
         "anew. Floor: what these deviations, the mesh and the form of the "
         "model (what a careful model is wrong by) allow";
}

Figure ladder_figure(const ReportData& data) {
  const ModelResults& model = *data.model;
  std::vector<SvgBar> bars;
  for (const Rung& rung : model.ladder) {
    std::string words = ladder_words(rung);
    if (rung.stopped_after > 0) {
      words += fmt::format(" ({})", updating::stopped_text(rung.stopped_after));
    }
    bars.push_back({words,
                    rung.error,
                    percent(rung.error),
                    &rung == &model.ladder.back() ? ink::blue : ink::grey});
  }
  const updating::Comparison& now = model.after;
  bars.push_back({"floor", now.floor, percent(now.floor), ink::yellow});
  return {"error-ladder",
          fmt::format("{} ({}).", error_words(data), floor_words(now)),
          svg_bars(bars,
                   "error ladder",
                   fmt::format("error of the {} [%], logarithmic",
                               data.bundle.modes ? "modes" : "FRFs"),
                   100.0)};
}

/// An FRF, and beside it how the model's error fell.
void add_pictures(const ReportData& data, Section& section) {
  const bool frf = !data.frfs.frfs.empty() && data.frfs.lines() > 1;
  if (!data.model) {
    if (frf) section.parts.emplace_back(frf_figure(data, {.height = 250.0}));
    return;
  }
  FigureRow row;
  if (frf) row.figures.push_back(frf_figure(data, {420.0, 280.0}));
  row.figures.push_back(ladder_figure(data));
  section.parts.emplace_back(std::move(row));
}

Section identified_section(const ReportData& data) {
  const std::vector<IdentifiedRow> rows =
      identified_rows(data.bundle, *data.model);
  DataTable table{
      "",
      {"<what", "<quantity", "value ± s.d.", "95 %", "deck or sheet", "change"},
      {}};
  for (const IdentifiedRow& row : rows) {
    table.rows.push_back({row.what,
                          row.quantity,
                          row.value,
                          row.interval,
                          row.nominal,
                          row.change});
  }
  Section section{"What was identified", {}};
  if (table.rows.empty()) {
    section.parts.emplace_back(
        Paragraph{"Nothing was identified: the model is as delivered."});
  } else {
    section.parts.emplace_back(table);
  }
  return section;
}

}  // namespace

std::vector<Section> front_sections(const ReportData& data) {
  Section first{"",
                {Paragraph{verdict_sentence(data), Paragraph::Kind::Verdict},
                 tested(data)}};
  if (const std::string limits = criteria_sentence(data); !limits.empty()) {
    first.parts.insert(first.parts.begin() + 1, Paragraph{limits});
  }
  add_pictures(data, first);
  std::vector<Section> sections{std::move(first)};
  if (!data.model) {
    if (!data.modes.modes.empty()) {
      sections.push_back({"What was identified", {mode_rows(data.modes)}});
    }
    return sections;
  }
  sections.push_back(identified_section(data));
  sections.push_back(sure_section(data));
  sections.push_back(next_section(data));
  return sections;
}

}  // namespace tapfit::tui
