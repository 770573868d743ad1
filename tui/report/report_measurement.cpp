#include "tui/report/report_measurement.hpp"

#include "modal/mode_set/mac.hpp"
#include "modal/poles/cmif.hpp"
#include "signal/frf_set/measured_coherence.hpp"
#include "tui/document/svg_heat_map.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/modes_text.hpp"
#include "tui/report/report_shapes.hpp"
#include "tui/report/report_traceability.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tapfit::tui {
namespace {

Section set_up_section(const ReportData& data) {
  Section section{"Set-up", {}, true};
  if (std::optional<Figure> sketch = set_up_sketch(data)) {
    section.parts.emplace_back(*std::move(sketch));
  }
  for (Part& part : traceability_parts(data)) {
    section.parts.push_back(std::move(part));
  }
  if (data.bundle.modes) {
    section.parts.emplace_back(Paragraph{
        "Modes were given: nothing is known of recordings and channels."});
  } else if (data.bundle.runs.empty()) {
    section.parts.emplace_back(Paragraph{
        "FRFs were given ready: nothing is known here of hammer, hits and "
        "channels."});
  }
  return section;
}

std::string placed_sensors(const acquisition::TestBundle& bundle,
                           const acquisition::Run& run) {
  std::string text;
  for (const acquisition::Placement& sensor : run.sensors) {
    text += fmt::format("{}{} ({})",
                        text.empty() ? "" : ", ",
                        name(sensor.dof),
                        bundle.channels.at(sensor.channel).name);
  }
  return text;
}

std::string reasons_of(const acquisition::Hit& hit) {
  std::string text;
  for (const acquisition::HitFault fault : hit.reasons) {
    text += (text.empty() ? "" : ", ") + name(fault);
  }
  return text;
}

Section hits_section(const ReportData& data) {
  DataTable runs{
      "",
      {"<run", "<hit at", "hits", "accepted", "largest peak N", "<sensors"},
      {}};
  DataTable rejected{
      "Rejected hits", {"<run", "time s", "peak N", "<reason"}, {}};
  const acquisition::HitSet& hits = *data.hits;
  for (std::size_t k = 0; k < hits.runs.size(); ++k) {
    const acquisition::Run& run = data.bundle.runs.at(k);
    const std::string file = run.file.filename().string();
    long accepted = 0;
    double peak = 0.0;
    for (const acquisition::Hit& hit : hits.runs[k]) {
      if (hit.accepted) {
        peak = std::max(peak, hit.peak_n);
        ++accepted;
        continue;
      }
      rejected.rows.push_back(
          {file, fixed(hit.time_s, 3), fixed(hit.peak_n, 1), reasons_of(hit)});
    }
    runs.rows.push_back({file,
                         name(run.hammer.dof),
                         fmt::format("{}", hits.runs[k].size()),
                         fmt::format("{}", accepted),
                         accepted > 0 ? fixed(peak, 1) : "–",
                         placed_sensors(data.bundle, run)});
  }
  Section section{"Hits", {runs}};
  if (rejected.rows.empty()) {
    section.parts.emplace_back(Paragraph{"No hit was rejected."});
  } else {
    section.parts.emplace_back(rejected);
  }
  BulletList by_hand;
  for (const updating::OverruledHit& hit : data.overruled) {
    by_hand.items.push_back(fmt::format(
        "Run {}, hit {} was judged manually.", hit.run + 1, hit.hit + 1));
  }
  section.parts.emplace_back(by_hand);
  return section;
}

std::string at_frf(const std::vector<double>& values,
                   std::size_t frf,
                   std::string (*written)(double)) {
  return frf < values.size() ? written(values[frf]) : "–";
}

std::string three_decimals(double value) { return fixed(value, 3); }

/// Mean and lowest of all FRFs.
std::optional<Figure> coherence_figure(const signal::FrfSet& frfs) {
  const Eigen::Index lines = frfs.lines();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(lines);
  Eigen::VectorXd low = Eigen::VectorXd::Ones(lines);
  int count = 0;
  for (const signal::Frf& frf : frfs.frfs) {
    if (!signal::has_coherence(frf) || frf.coherence.size() != lines) continue;
    sum += frf.coherence;
    low = low.cwiseMin(frf.coherence);
    ++count;
  }
  if (count == 0 || lines < 2) return std::nullopt;
  const Eigen::VectorXd hz = frfs.frequency_hz();
  Plot plot;
  plot.title = "coherence";
  plot.x = {"frequency", "Hz", hz(0), hz(lines - 1), false};
  plot.y = {"coherence", "", 0.0, 1.05, false};
  plot.curves = {
      {"lowest of all", hz, low, {}, {}, {Colour::Orange}},
      {"mean", hz, sum / static_cast<double>(count), {}, {}, {Colour::Blue}}};
  return Figure{"coherence",
                fmt::format("Coherence of {} FRFs.", count),
                svg_plot(plot, {.height = 220.0})};
}

Section frf_section(const ReportData& data) {
  DataTable table{
      "", {"<response / hammer", "hits", "coherence", "median s.d."}, {}};
  if (data.model) {
    for (const char* more :
         {"error before", "error after", "FRAC before", "FRAC after"}) {
      table.heading.emplace_back(more);
    }
  }
  for (std::size_t k = 0; k < data.frfs.frfs.size(); ++k) {
    const signal::Frf& frf = data.frfs.frfs[k];
    const double sd = median_sd_percent(frf);
    std::vector<std::string> row{
        name(frf),
        frf.hits > 0 ? fmt::format("{}", frf.hits) : "–",
        signal::has_coherence(frf) ? fixed(frf.coherence.mean(), 4) : "–",
        sd > 0.0 ? percent(sd / 100.0) : "–"};
    if (data.model) {
      const updating::Comparison& before = data.model->before;
      const updating::Comparison& after = data.model->after;
      row.push_back(at_frf(before.frf_error, k, percent));
      row.push_back(at_frf(after.frf_error, k, percent));
      row.push_back(at_frf(before.frac, k, three_decimals));
      row.push_back(at_frf(after.frac, k, three_decimals));
    }
    table.rows.push_back(std::move(row));
  }
  BulletList statements;
  for (const std::string& statement : data.frfs.statements) {
    statements.items.push_back(capitalised(typeset(statement)));
  }
  Section section{
      "Quality of the FRFs",
      {table,
       Paragraph{"Coherence: mean over the band. Median s.d.: standard "
                 "deviation over the hits, in per cent of |H|.",
                 Paragraph::Kind::Small}}};
  if (std::optional<Figure> coherence = coherence_figure(data.frfs)) {
    section.parts.emplace_back(*std::move(coherence));
  }
  section.parts.emplace_back(statements);
  return section;
}

/// The letters of the diagram from the least steady on.
struct Steadiness {
  char letter;
  const char* words;
  Pen pen;
};
constexpr std::array<Steadiness, 5> steadiness{
    {{'o', "new", {Colour::Grey, Pattern::Solid, 'o', true}},
     {'f', "frequency", {Colour::Yellow, Pattern::Solid, 'f', true}},
     {'d', "+ damping", {Colour::Orange, Pattern::Solid, 'd', true}},
     {'v', "+ shape", {Colour::Blue, Pattern::Solid, 'v', true}},
     {'s', "stable", {Colour::Green, Pattern::Solid, 's'}}}};

Figure stabilisation(const ReportData& data) {
  const Eigen::VectorXd hz = data.frfs.frequency_hz();
  Plot plot;
  plot.title = "stabilisation diagram";
  plot.x = {"frequency", "Hz", hz(0), hz(hz.size() - 1), false};
  plot.y = {"model order", "", 0.0, 0.0, false};
  int highest = 1;
  for (const modal::DiagramPole& pole : data.modes.diagram) {
    highest = std::max(highest, pole.order);
  }
  plot.y.hi = highest + 2.0;
  const Eigen::VectorXd sum = modal::summed_frf(data.frfs).array().log10();
  const double low = sum.minCoeff();
  const double span = std::max(sum.maxCoeff() - low, 1e-9);
  plot.curves.push_back(
      {"sum of |H| (log)",
       hz,
       ((sum.array() - low) / span * 0.95 * plot.y.hi).matrix(),
       {},
       {},
       {Colour::Grey}});
  for (const Steadiness& kind : steadiness) {
    std::vector<double> x;
    std::vector<double> y;
    for (const modal::DiagramPole& pole : data.modes.diagram) {
      if (pole.letter != kind.letter) continue;
      x.push_back(pole.frequency_hz);
      y.push_back(pole.order);
    }
    if (x.empty()) continue;
    const auto n = static_cast<Eigen::Index>(x.size());
    plot.curves.push_back({kind.words,
                           Eigen::Map<Eigen::VectorXd>(x.data(), n),
                           Eigen::Map<Eigen::VectorXd>(y.data(), n),
                           {},
                           {},
                           kind.pen,
                           false});
  }
  for (const modal::Mode& mode : data.modes.modes) {
    plot.markers.push_back({mode.frequency_hz});
  }
  return {"stabilisation",
          "Stabilisation diagram: poles of models of rising order, coloured by "
          "what agrees with the order below: frequency, with damping, with "
          "shape, or all three (stable). Dotted lines are the modes taken.",
          svg_plot(plot, {.height = 340.0})};
}

/// How well the measured points tell the modes apart.
Figure auto_mac_figure(const modal::ModeSet& modes) {
  Eigen::MatrixXcd shapes(static_cast<Eigen::Index>(modes.dofs.size()),
                          static_cast<Eigen::Index>(modes.modes.size()));
  SvgHeatMap map;
  map.name = "AutoMAC";
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    shapes.col(static_cast<Eigen::Index>(k)) = modes.modes[k].shape;
    map.rows.push_back(four_digits(modes.modes[k].frequency_hz));
  }
  map.columns = map.rows;
  map.values = modal::auto_mac(shapes);
  map.row_title = map.column_title = "measured Hz";
  return {"auto-mac",
          "AutoMAC in %: the modes among themselves. What is large off the "
          "diagonal the measured points cannot tell apart.",
          svg_heat_map(map)};
}

Section mode_section(const ReportData& data) {
  // Without a model the modes are the result and stand in front.
  Section section{data.model ? "Modes" : "Quality of the modes", {}};
  if (data.modes.modes.empty()) {
    section.parts.emplace_back(Paragraph{"No mode was identified."});
  } else if (data.model) {
    section.parts.emplace_back(mode_rows(data.modes));
  }
  if (!data.modes.modes.empty() && !data.bundle.modes) {
    section.parts.emplace_back(Paragraph{
        fmt::format("FRFs synthesised from the modes differ from those "
                    "measured by {}. MPC and MPD: how far the points of a mode "
                    "move in phase (1 and 0° for a real mode). Poles and "
                    "scatter: of the mode in the stabilisation diagram.",
                    percent(data.modes.synthesis_error)),
        Paragraph::Kind::Small});
  }
  if (!data.modes.diagram.empty() && data.frfs.lines() > 1) {
    section.parts.emplace_back(stabilisation(data));
  }
  if (!data.model && data.modes.dofs.size() > 1 &&
      data.modes.modes.size() > 1) {
    section.parts.emplace_back(FigureRow{{auto_mac_figure(data.modes)}});
  }
  return section;
}

}  // namespace

DataTable mode_rows(const modal::ModeSet& modes) {
  const bool shapes = !modes.dofs.empty();
  const bool poles = std::ranges::any_of(
      modes.modes, [](const modal::Mode& m) { return m.cluster.poles > 0; });
  DataTable table{"", {"mode", "frequency Hz", "damping %"}, {}};
  const auto add_heading = [&table](
                               bool told, const char* one, const char* two) {
    if (told) table.heading.insert(table.heading.end(), {one, two});
  };
  add_heading(shapes, "MPC", "MPD °");
  add_heading(poles, "poles", "scatter mHz");
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    const modal::Mode& mode = modes.modes[k];
    std::vector<std::string> row{
        fmt::format("{}", k + 1),
        with_sd(mode.frequency_hz, mode.frequency_sd_hz),
        damping_words(mode)};
    if (shapes) {
      row.push_back(mpc_words(mode));
      row.push_back(fixed(mode.mpd_deg, 1));
    }
    if (poles) {
      const modal::PoleCluster& found = mode.cluster;
      row.push_back(found.poles > 0 ? fmt::format("{}", found.poles) : "–");
      row.push_back(
          found.poles > 0 ? number(1e3 * found.frequency_scatter_hz, 2) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<Section> measurement_sections(const ReportData& data) {
  std::vector<Section> sections{set_up_section(data)};
  if (data.hits) sections.push_back(hits_section(data));
  if (!data.bundle.modes) sections.push_back(frf_section(data));
  if (data.model || !data.bundle.modes || data.modes.dofs.size() > 1) {
    sections.push_back(mode_section(data));
  }
  return sections;
}

}  // namespace tapfit::tui
