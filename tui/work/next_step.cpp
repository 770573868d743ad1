#include "tui/work/next_step.hpp"

#include "tui/screen/number.hpp"
#include "tui/widgets/bars.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

std::string after_hits(const Snapshot& known) {
  if (!known.hits) return {};
  std::size_t all = 0;
  std::size_t rejected = 0;
  for (const auto& run : known.hits->runs) {
    all += run.size();
    rejected += static_cast<std::size_t>(
        std::ranges::count(run, false, &acquisition::Hit::accepted));
  }
  if (rejected == 0) {
    return fmt::format("all {} hits are accepted: 2 shows the FRFs", all);
  }
  return fmt::format(
      "{} of {} hits {} rejected: N goes to {}, 2 shows the FRFs",
      rejected,
      all,
      rejected == 1 ? "is" : "are",
      rejected == 1 ? "it" : "them");
}

std::string after_modes(const Snapshot& known) {
  if (!known.modes) return {};
  return known.has_model ? "4 compares them with the model"
                         : "w on 7 writes the report";
}

/// @param missing what to do while the error is above its floor
std::string after_error(const Snapshot& known, const std::string& missing) {
  if (!known.comparison) return {};
  const updating::Comparison& c = *known.comparison;
  constexpr double high = 0.3;  // hides more than it shows
  if (c.floor > high) {
    return fmt::format(
        "a floor of {} hides what is missing: 7 has the warnings",
        percent(c.floor));
  }
  if (!(c.floor > 0.0) || c.error <= near_floor * c.floor) {
    return fmt::format("{} is within the floor: 7 reports it",
                       percent(c.error));
  }
  return fmt::format("{} is {} times the floor: {}",
                     percent(c.error),
                     number(c.error / c.floor, 2),
                     missing);
}

std::string after_diagnosis(const Snapshot& known) {
  if (!known.diagnosis) return {};
  const std::size_t found = known.diagnosis->ladder.size();
  if (found == 0) return "7 reports it";
  return found == 1 ? "A adds what the verdict names, a the marked candidate"
                    : fmt::format(
                          "A adds all {} of the verdict, a the marked "
                          "candidate alone",
                          found);
}

std::string for_report(const Snapshot& known) {
  if (!known.has_model) return "w writes the report";
  if (!known.comparison) return {};
  const bool asked = known.diagnosis || !known.effects_on().empty();
  return asked ? "w writes the report, e the deck, f FRFs and modes"
               : "5 shows what is missing, w writes the report";
}

}  // namespace

std::string step_words(std::size_t screen, const Snapshot& known) {
  std::string words;
  switch (screen) {
    case 0:
      words = after_hits(known);
      break;
    case 1:
      words = known.frfs ? "3 identifies the modes" : "";
      break;
    case 2:
      words = after_modes(known);
      break;
    case 3:
      words = after_error(known, "5 shows what is missing");
      break;
    case 4:
      words = after_diagnosis(known);
      break;
    case 5:
      words = after_error(known,
                          known.effects_on().empty()
                              ? "5 shows what is missing"
                              : "5 shows what else is missing");
      break;
    default:
      words = for_report(known);
  }
  return words.empty() ? words : "next: " + words;
}

}  // namespace tapfit::tui
