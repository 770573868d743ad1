#include "tui/workbench/tour_words.hpp"

namespace tapfit::tui {
namespace {

constexpr const char* recording =
    "1 of 7. A row is a run, a mark in its record a hit: what the hammer gave "
    "and the sensors answered. N goes to a hit that was rejected, with the "
    "reason; Space overrules. R replays the run as if it were being measured. "
    "Then 2.";

constexpr const char* no_recordings =
    "1 of 7. This test came without recordings, as FRFs or modes, and is taken "
    "up there. Then 2.";

constexpr const char* no_frfs =
    "2 of 7. This test consists of modes, and has no FRFs. Then 3.";

constexpr const char* comparison_of_modes =
    "4 of 7. The model's modes beside those that were measured. The error is "
    "the share of what was measured that it misses, the floor what a right "
    "model would miss, too. Then 5.";

constexpr const char* frfs =
    "2 of 7. FRFs: what the structure answers to a newton, with coherence and "
    "the scatter over the hits. j k go through them, n p from peak to peak, d "
    "to the checks: driving points, reciprocity. Then 3.";

constexpr const char* modes =
    "3 of 7. Modes, read off the stabilisation diagram, with how well they are "
    "known. j k choose one, m shows its MAC, Space lets it swing; p puts a "
    "pole in, x takes one out. Then 4.";

constexpr const char* no_model =
    "This test has no model, and the work ends with the modes: 7 reports them.";

constexpr const char* comparison =
    "4 of 7. The model over the measurement. The error is the share of the "
    "FRFs that it misses, the floor what a right model would miss, too. The "
    "map says which FRF fails in which band; Enter opens it. Then 5.";

constexpr const char* being_tried =
    "5 of 7. All effects are tried at all places. What has been fitted is "
    "listed already and can be added; the verdict waits for all, half a "
    "minute on the demonstration. Where it was stopped, r begins again.";

constexpr const char* nothing_found =
    "5 of 7. The verdict, and what was tried. No effect was found that the "
    "data ask for; i says what that stands on. Then 7.";

constexpr const char* verdict =
    "5 of 7. The verdict, and below it what was tried: size, probability, and "
    "the error that would be left. i has the notes, m the map of where it is "
    "missing. Now A: it adds all that the verdict names.";

constexpr const char* nothing_added =
    "6 of 7. What is added to the model stands here. Nothing is yet: on 5, A "
    "adds the verdict and a the effect that is marked.";

constexpr const char* added =
    "6 of 7. The effects are in the model, all sizes identified together, and "
    "the ladder shows the error fall. Space switches one off and on, u undoes, "
    "Ctrl-R does it again. Then 7.";

constexpr const char* report =
    "7 of 7. The result; w writes report.html to hand on. All of it is there "
    "when the test is opened again. On every screen ? has the keys and the "
    "line below the next step. :tour ends the tour, q leaves.";

const char* on_diagnosis(const Snapshot& known) {
  if (!known.diagnosis) return being_tried;
  return known.diagnosis->ladder.empty() ? nothing_found : verdict;
}

}  // namespace

std::string tour_words(std::size_t screen, const Snapshot& known) {
  constexpr std::size_t first_about_model = 3;
  constexpr std::size_t last = 6;
  const bool wants_model = screen >= first_about_model && screen < last;
  if (wants_model && known.bundle && !known.has_model) return no_model;
  const bool of_modes = known.bundle && known.bundle->modes;
  const bool recorded =
      !known.bundle || !(known.bundle->frfs || known.bundle->modes);
  switch (screen) {
    case 0:
      return recorded ? recording : no_recordings;
    case 1:
      return of_modes ? no_frfs : frfs;
    case 2:
      return modes;
    case 3:
      return of_modes ? comparison_of_modes : comparison;
    case 4:
      return on_diagnosis(known);
    case 5:
      return known.effects.empty() ? nothing_added : added;
    default:
      return report;
  }
}

}  // namespace tapfit::tui
