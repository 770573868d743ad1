#include "tui/report/report_evidence.hpp"

#include "tui/document/svg_plot.hpp"
#include "tui/report/report_shapes.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

using updating::EffectEvidence;
using updating::Rung;

/// @param marked where it sits is seen beside
std::string errors_of(const Rung& rung,
                      const EffectEvidence& evidence,
                      bool marked) {
  if (rung.added == updating::uncertain_rung) {
    return fmt::format(
        "Uncertain properties of the model, before any effect: error {} as "
        "delivered, {} identified.",
        percent(evidence.error_without),
        percent(evidence.error_with));
  }
  return fmt::format("{}{}: {}.",
                     capitalised(found_words(rung.added, rung.where)),
                     marked ? ", in green" : "",
                     drop_words(evidence.error_without, evidence.error_with));
}

/// @pre it is known which FRF
Figure curves_figure(const ReportData& data,
                     const EffectEvidence& evidence,
                     const std::string& name) {
  const signal::Frf& frf = data.frfs.frfs.at(*evidence.frf);
  const Eigen::VectorXd hz = data.frfs.frequency_hz();
  Plot plot;
  plot.title = "FRF " + signal::name(frf);
  plot.x = {"frequency", "Hz", 0.0, 0.0, false};
  plot.y = {"|H|", "(m/s²)/N", 0.0, 0.0, true};
  plot.curves = {{"measured", hz, frf.H.cwiseAbs(), {}, {}, {}}};
  const auto add =
      [&](const char* label, const Eigen::VectorXcd& H, const Pen& pen) {
        if (H.size() != hz.size()) return;
        plot.curves.push_back({label, hz, H.cwiseAbs(), {}, {}, pen});
      };
  add("without it", evidence.without, {Colour::Orange, Pattern::Dashed});
  add("with it", evidence.with, {Colour::Blue, Pattern::Dotted});
  return {name,
          fmt::format("FRF {}, where it shows most: error {} → {}.",
                      signal::name(frf),
                      percent(evidence.frf_error_without),
                      percent(evidence.frf_error_with)),
          svg_plot(plot, {420.0, 260.0})};
}

}  // namespace

std::vector<Section> evidence_sections(const ReportData& data) {
  if (!data.model || data.model->evidence.empty()) return {};
  Section section{"Evidence for each effect", {}};
  const std::vector<Rung>& ladder = data.model->ladder;
  const std::vector<EffectEvidence>& evidence = data.model->evidence;
  const std::size_t count = std::min(evidence.size(), ladder.size() - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const Rung& rung = ladder[k + 1];
    FigureRow row;
    auto place = place_figure(data, rung.where, fmt::format("place-{}", k + 1));
    const std::string words = errors_of(rung, evidence[k], place.has_value());
    if (place) row.figures.push_back(*std::move(place));
    if (evidence[k].frf && *evidence[k].frf < data.frfs.frfs.size()) {
      row.figures.push_back(curves_figure(
          data, evidence[k], fmt::format("with-and-without-{}", k + 1)));
    }
    // A caption stays with its picture where a page ends.
    if (row.figures.empty()) {
      section.parts.emplace_back(Paragraph{words});
      continue;
    }
    std::string& caption = row.figures.front().caption;
    caption = words + (caption.empty() ? "" : " ") + caption;
    section.parts.emplace_back(std::move(row));
  }
  section.parts.emplace_back(Paragraph{
      "Without one effect all others, and what is uncertain in the model, were "
      "fitted anew: what is left then is what no other can make up for.",
      Paragraph::Kind::Small});
  return {section};
}

}  // namespace tapfit::tui
