#include "tui/views/diagnose_details.hpp"

#include "tui/report/report_words.hpp"
#include "tui/report/robustness_output.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/candidate_table.hpp"
#include "tui/widgets/bars.hpp"

#include <fmt/format.h>

namespace tapfit::tui {

using updating::Candidate;

std::string verdict_words(const updating::Diagnosis& d) {
  if (d.verdict.empty()) return "no verdict yet";
  if (d.verdict != "none") return "verdict: " + d.verdict;
  return fmt::format("nothing significant is missing (error {})",
                     against_floor(d.error_base, d.floor));
}

std::string indistinguishable(const Candidate& c) {
  if (c.indistinguishable_from.empty()) return "uniquely identified";
  std::string text = "indistinguishable with these points from:";
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
        is_open(p)
            ? fmt::format("{} (95 %)", size)
            : fmt::format(
                  "{} (95 %: {} to {})", size, number(p.lo95), number(p.hi95));
  }
  return text.empty() ? "no parameters" : text;
}

std::vector<std::string> details_of(const updating::Diagnosis& d,
                                    const Candidate& c,
                                    int width) {
  std::vector<std::string> paragraphs{verdict_words(d),
                                      contour_words(d.contour)};
  for (const std::string& warning : d.warnings) {
    paragraphs.push_back("! " + warning);
  }
  std::string found = fmt::format(
      "{} at {}: error {}", c.effect, place(c.where), percent(c.error));
  if (!d.verdict.empty()) {
    found += fmt::format(", hold-out error {}, probability {}",
                         left_out(c),
                         probability(c.probability));
  }
  paragraphs.push_back(found);
  paragraphs.push_back(all_sizes(c));
  if (!d.verdict.empty()) {
    paragraphs.push_back(next_step(d, c) + indistinguishable(c));
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
