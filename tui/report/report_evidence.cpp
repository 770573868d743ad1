#include "tui/report/report_evidence.hpp"

#include "tui/document/svg_plot.hpp"
#include "tui/report/report_shapes.hpp"
#include "tui/report/report_verdict.hpp"
#include "tui/report/report_words.hpp"
#include "tui/report/robustness_output.hpp"
#include "tui/screen/number.hpp"
#include "updating/comparison/compare.hpp"

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

std::string alike_words(const ReportData& data,
                        const std::vector<updating::EffectRef>& alike) {
  constexpr std::size_t most = 3;
  if (alike.empty()) return "uniquely identified";
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(alike.size(), most); ++k) {
    names.push_back(found_words(alike[k].effect, alike[k].where));
  }
  const std::string text = fmt::format("indistinguishable with these {} from: ",
                                       data.bundle.modes ? "modes" : "points");
  if (alike.size() > most) {
    names.push_back(fmt::format("{} more", alike.size() - most));
  }
  return text + enumerated(names);
}

std::string held_out_words(const updating::Diagnosis& diagnosis,
                           const Rung& rung) {
  for (const updating::Candidate& candidate : diagnosis.candidates) {
    if (candidate.effect == leading_kind(rung) &&
        candidate.where == rung.where && candidate.held_out_error > 0.0) {
      return percent(candidate.held_out_error);
    }
  }
  return "–";
}

std::string rest_words(const ModelResults& model) {
  if (!model.rest) return {};
  if (model.rest->verdict == "none") {
    return "Diagnosed again with these effects in the model: nothing "
           "significant is missing any more.";
  }
  return fmt::format(
      "Diagnosed again with these effects in the model: {} is still missing.",
      model.rest->verdict == "unexplained"
          ? "something that no known effect explains"
          : effect_words(model.rest->verdict));
}

/// Of what is in the model, the first that something else explains as well.
const Rung* first_alike(const ModelResults& model) {
  for (const Rung& rung : model.diagnosis->ladder) {
    if (!rung.alike.empty()) return &rung;
  }
  return nullptr;
}

/// Why no measurement is proposed, or what no point would tell.
std::string no_next_words(const ReportData& data) {
  const ModelResults& model = *data.model;
  if (!model.diagnosis) {
    return "Nothing is proposed: what may be missing has not been looked for.";
  }
  if (!is_diagnosed(model)) {
    return "Nothing is proposed: the model is not the one that was diagnosed.";
  }
  const Rung* rung = first_alike(model);
  if (rung == nullptr) {
    return "No further measurement is proposed: nothing found has a look-alike "
           "that other points would separate.";
  }
  const updating::EffectRef& other = rung->alike.front();
  const std::string pair =
      fmt::format("{} from {}",
                  with_article(found_words(leading_kind(*rung), rung->where)),
                  with_article(found_words(other.effect, other.where)));
  if (data.bundle.modes && data.modes.dofs.empty()) {
    return fmt::format(
        "Measure mode shapes: frequencies alone do not separate {}.", pair);
  }
  return fmt::format("No measurement is known that would separate {}.", pair);
}

}  // namespace

Section sure_section(const ReportData& data) {
  const ModelResults& model = *data.model;
  Section section{"How sure is it", {}};
  if (!model.diagnosis) {
    section.parts.emplace_back(Paragraph{
        "No diagnosis of the base model is known: effects were chosen by hand, "
        "and how probable others are has not been worked out."});
    return section;
  }
  // On other runs the whole verdict was tried.
  const bool whole = is_diagnosed(model);
  DataTable table{
      "", {"<effect", "probability", "hold-out error", "<look-alikes"}, {}};
  for (const Rung& rung : effect_rungs(model.ladder)) {
    const Rung* found = diagnosed_rung(model, rung);
    if (found == nullptr) {
      table.rows.push_back(
          {found_words(rung.added, rung.where), "–", "–", "added by hand"});
      continue;
    }
    table.rows.push_back(
        {found_words(found->added, found->where),
         probability(found->probability),
         whole ? held_out_words(*model.diagnosis, *found) : "–",
         alike_words(data, found->alike)});
  }
  if (table.rows.empty()) {
    section.parts.emplace_back(Paragraph{fmt::format(
        "{} candidates were tried; none lowers the error enough to pay for its "
        "parameters.",
        model.diagnosis->candidates.size())});
  } else {
    section.parts.emplace_back(table);
    section.parts.emplace_back(Paragraph{
        "Probability: among all effects and places that were tried. Hold-out "
        "error: on runs that the parameters were not fitted to.",
        Paragraph::Kind::Small});
  }
  if (const auto& rows = model.diagnosis->robustness; !rows.empty()) {
    section.parts.emplace_back(
        Paragraph{capitalised(firmness_words(rows)) + "."});
  }
  if (const std::string rest = rest_words(model); !rest.empty()) {
    section.parts.emplace_back(Paragraph{rest});
  }
  return section;
}

Section next_section(const ReportData& data) {
  const ModelResults& model = *data.model;
  BulletList list;
  if (updating::hides_errors(model.after.floor)) {
    list.items.push_back(
        capitalised(typeset(updating::floor_warning(model.after))) + ".");
  }
  if (is_diagnosed(model)) {
    for (const updating::NextMeasurement& next : model.diagnosis->next) {
      list.items.push_back(next_words(next, model.diagnosis->floor));
    }
    for (const updating::SetUpMistake& mistake : model.diagnosis->set_up) {
      list.items.push_back(
          fmt::format("Check the sheet, {}, and correct {}.",
                      found_words(mistake.mistake, mistake.where),
                      mistake.edit));
    }
  }
  Section section{"What to measure next", {}};
  if (list.items.empty()) {
    section.parts.emplace_back(Paragraph{no_next_words(data)});
  } else {
    section.parts.emplace_back(list);
  }
  return section;
}

std::vector<Section> evidence_sections(const ReportData& data) {
  if (!data.model || data.model->evidence.empty()) return {};
  const bool effects = !effect_rungs(data.model->ladder).empty();
  Section section{effects ? "Evidence for each effect"
                          : "What identifying the model changes",
                  {}};
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
  if (!effects) return {section};
  section.parts.emplace_back(Paragraph{
      "Without one effect all others, and what is uncertain in the model, were "
      "fitted anew: what is left then is what no other can make up for.",
      Paragraph::Kind::Small});
  return {section};
}

std::vector<Section> firmness_sections(const ReportData& data) {
  if (!data.model || !data.model->diagnosis) return {};
  const RobustnessRows& rows = data.model->diagnosis->robustness;
  if (rows.empty()) return {};
  DataTable table{
      "", {"<what was changed", "<verdict", "<farthest move of a size"}, {}};
  for (const updating::Robustness& row : rows) {
    const std::string move = move_text(row);
    table.rows.push_back(
        {row.change,
         row.verdict_stands ? "stands" : effect_words(row.verdict),
         move.empty() ? "–" : move});
  }
  return {{"How firm the verdict is",
           {table,
            Paragraph{"What was found and what came closest were fitted again "
                      "with each of these changed; sd: standard deviations of "
                      "the size as stated.",
                      Paragraph::Kind::Small}}}};
}

}  // namespace tapfit::tui
