#include "tui/workbench/next_step.hpp"

#include "signal/frf_set/measured_coherence.hpp"
#include "tui/screen/number.hpp"
#include "tui/widgets/bars.hpp"
#include "updating/comparison/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace tapfit::tui {
namespace {

constexpr std::size_t first_about_model = 3;
constexpr std::size_t report_screen = 6;

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

std::vector<double> mean_coherences(const signal::FrfSet& frfs) {
  std::vector<double> means;
  for (const signal::Frf& frf : frfs.frfs) {
    if (signal::has_coherence(frf)) means.push_back(frf.coherence.mean());
  }
  return means;
}

std::string after_frfs(const Snapshot& known) {
  if (!known.frfs) return {};
  const std::vector<double> means = mean_coherences(*known.frfs);
  if (means.empty()) {
    return fmt::format("{} FRFs: 3 identifies the modes",
                       known.frfs->frfs.size());
  }
  const double sum = std::accumulate(means.begin(), means.end(), 0.0);
  return fmt::format(
      "coherence {} on average, {} at worst: 3 identifies the modes",
      fixed(sum / static_cast<double>(means.size()), 3),
      fixed(std::ranges::min(means), 3));
}

std::string after_modes(const Snapshot& known) {
  if (!known.modes) return {};
  const std::size_t count = known.modes->modes.size();
  if (count == 0) {
    return "no mode was found: h l to a pole and p picks it, :band sets "
           "another "
           "band";
  }
  const char* next = known.has_model ? "4 compares with the model"
                                     : "w on 7 writes the report";
  const bool given = known.bundle && known.bundle->modes;
  if (given) {
    return fmt::format("{} mode{} {} given: {}",
                       count,
                       count == 1 ? "" : "s",
                       count == 1 ? "was" : "were",
                       next);
  }
  return fmt::format("{} mode{} leave{} {} of the FRFs unexplained: {}",
                     count,
                     count == 1 ? "" : "s",
                     count == 1 ? "s" : "",
                     percent(known.modes->synthesis_error),
                     next);
}

std::string hidden(double floor) {
  return fmt::format("a floor of {} hides what is missing: ", percent(floor));
}

/// @param missing what to do while the error is above its floor
std::string after_error(const Snapshot& known, const std::string& missing) {
  if (!known.comparison) return {};
  const updating::Comparison& c = *known.comparison;
  if (updating::hides_errors(c.floor)) {
    return hidden(c.floor) + "7 has the warnings";
  }
  const bool near = !(c.floor > 0.0) || c.error <= near_floor * c.floor;
  return fmt::format("{} is {}: {}",
                     percent(c.error),
                     against_floor(c.error, c.floor),
                     near ? "7 reports it" : missing);
}

std::string after_diagnosis(const Snapshot& known) {
  if (!known.diagnosis) return {};
  const updating::Diagnosis& d = *known.diagnosis;
  const std::size_t found = d.ladder.size();
  if (found == 0 && d.verdict == "none") {
    if (updating::hides_errors(d.floor)) {
      return hidden(d.floor) + "7 has the warnings";
    }
    return d.error_best <= near_floor * d.floor
               ? "nothing significant is missing: 7 reports it"
               : "no effect is supported by the data: 7 reports it";
  }
  if (found == 0) return "no effect of the list explains it: i says what may";
  const std::string what =
      found == 1 ? d.ladder.front().added : fmt::format("{} effects", found);
  return fmt::format("{} take{} {} down to {}: A adds {}",
                     what,
                     found == 1 ? "s" : "",
                     percent(d.error_base),
                     percent(d.ladder.back().error),
                     found == 1 ? "it" : "them all");
}

std::string for_report(const Snapshot& known) {
  if (!known.comparison) return {};
  const bool asked = known.diagnosis || !known.effects_on().empty();
  const updating::Comparison& c = *known.comparison;
  if (updating::hides_errors(c.floor)) {
    return hidden(c.floor) + "w writes the report";
  }
  // Where nothing was ever added the report takes up the verdict.
  const bool taken_up = known.effects.empty() && known.diagnosis &&
                        !known.diagnosis->ladder.empty();
  if (taken_up) {
    return fmt::format("w writes the report with the verdict in it: {} → {}",
                       percent(known.diagnosis->error_base),
                       percent(known.diagnosis->ladder.back().error));
  }
  if (!asked && c.error > near_floor * c.floor) {
    return after_error(known, "5 shows what is missing");
  }
  if (!asked || !known.base_comparison) {
    return fmt::format("error {}, floor {}: w writes the report",
                       percent(c.error),
                       percent(c.floor));
  }
  return fmt::format("error {} → {}, floor {}: w writes the report",
                     percent(known.base_comparison->error),
                     percent(c.error),
                     percent(c.floor));
}

/// Where the screen wants a model and there is none.
std::string without_model(std::size_t screen, const Snapshot& known) {
  if (screen == report_screen) {
    return "without a model the work ends with the modes: w writes the report";
  }
  return known.modes
             ? "without a model the work ends with the modes: 7 reports "
               "them"
             : "no model to compare with: 3 identifies the modes";
}

}  // namespace

std::string step_words(std::size_t screen, const Snapshot& known) {
  std::string words;
  switch (screen) {
    case 0:
      words = after_hits(known);
      break;
    case 1:
      words = after_frfs(known);
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
  const bool about_model = screen >= first_about_model;
  if (known.bundle && about_model && !known.has_model) {
    words = without_model(screen, known);
  }
  return words.empty() ? words : "next: " + words;
}

}  // namespace tapfit::tui
