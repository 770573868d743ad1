#include "tui/views/diagnose_details.hpp"

#include "tui/report/report_words.hpp"
#include "tui/report/robustness_output.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/candidate_table.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/workbench/diagnosed_effects.hpp"
#include "updating/comparison/compare.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {

using updating::Candidate;

std::string verdict_words(const updating::Diagnosis& d) {
  if (d.verdict.empty()) return "no verdict yet";
  if (d.verdict != "none") return "verdict: " + d.verdict;
  if (updating::hides_errors(d.floor)) {
    return fmt::format("a floor of {} hides what is missing", percent(d.floor));
  }
  return fmt::format("{} (error {})",
                     d.error_best <= near_floor * d.floor
                         ? "nothing significant is missing"
                         : "no effect is supported by the data",
                     against_floor(d.error_best, d.floor));
}

std::string indistinguishable(const updating::Diagnosis& d,
                              const Candidate& c,
                              bool of_modes) {
  if (c.indistinguishable_from.empty()) {
    // Of what was rejected nothing is identified.
    const bool found = std::ranges::any_of(
        verdict_of(d), [&c](const updating::EffectRef& ref) {
          return ref.effect == c.effect && ref.where == c.where;
        });
    return found ? "uniquely identified" : "";
  }
  std::string text = fmt::format("indistinguishable with these {} from:",
                                 of_modes ? "modes" : "points");
  for (const updating::EffectRef& other : c.indistinguishable_from) {
    text += fmt::format(" {} {};", other.effect, place(other.where));
  }
  text.pop_back();
  return text;
}

std::string next_step(const updating::Diagnosis& d, const Candidate& c) {
  for (const updating::NextMeasurement& next : d.next) {
    if (next.one.effect != c.effect || next.one.where != c.where) continue;
    return next_words(next, d.floor) + " ";
  }
  return {};
}

std::string all_sizes(const Candidate& c) {
  std::string text;
  for (const updating::Estimate& p : told(c.parameters)) {
    const std::string size = (text.empty() ? "" : "; ") + describe(p);
    text +=
        is_open(p) ? fmt::format("{} (95 %)", size)
        : !(p.lo95 < p.hi95)
            ? size
            : fmt::format(
                  "{} (95 %: {} to {})", size, number(p.lo95), number(p.hi95));
  }
  return text.empty() ? "no parameters" : text;
}

std::vector<std::string> details_of(const updating::Diagnosis& d,
                                    const Candidate& c,
                                    int width,
                                    bool of_modes) {
  std::vector<std::string> paragraphs{verdict_words(d),
                                      contour_words(d.contour)};
  for (const std::string& warning : d.warnings) {
    paragraphs.push_back("! " + warning);
  }
  std::string found = fmt::format(
      "{} at {}: error {}", c.effect, place(c.where), percent(c.error));
  if (!d.verdict.empty()) {
    if (c.held_out_error > 0.0) {
      found += fmt::format(", hold-out error {}", left_out(c));
    }
    found += fmt::format(", probability {}", probability(c.probability));
  }
  paragraphs.push_back(found);
  paragraphs.push_back(all_sizes(c));
  if (!d.verdict.empty()) {
    std::string alike = next_step(d, c) + indistinguishable(d, c, of_modes);
    if (!alike.empty()) paragraphs.push_back(std::move(alike));
  }
  std::vector<std::string> lines;
  for (const std::string& paragraph : paragraphs) {
    if (!lines.empty()) lines.emplace_back();
    for (const std::string& line : wrapped(paragraph, width)) {
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<std::string> firmness_lines(const updating::Diagnosis& d,
                                        int width) {
  if (d.robustness.empty()) {
    return wrapped(
        "how firm the verdict is: worked out while other screens stay "
        "usable … Each prior is halved and doubled, what is "
        "uncertain held, each run left out; the verdict and what came "
        "closest are fitted again from where they were.",
        width);
  }
  std::vector<std::string> lines = wrapped(firmness_words(d.robustness), width);
  lines.emplace_back();
  for (std::string& line : robustness_table(d.robustness)) {
    lines.push_back(clipped(line, width));
  }
  return lines;
}

}  // namespace tapfit::tui
