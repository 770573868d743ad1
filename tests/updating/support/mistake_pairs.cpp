#include "tests/updating/support/mistake_pairs.hpp"

#include <set>
#include <string>

namespace tapfit::updating::testing {
namespace {

using Names = std::set<std::string>;

const Names& without_hits() {
  static const Names names{"hammer overloaded",
                           "times in ms read as s",
                           "time axis reversed",
                           "hammer and sensor exchanged",
                           "columns in another order",
                           "trigger within the noise"};
  return names;
}

const Names& in_the_samples() {
  static const Names names{"run listed twice", "samples lost"};
  return names;
}

const Names& other_kind() {
  static const Names names{"velocity for acceleration",
                           "displacement for acceleration"};
  return names;
}

// Of the first sensor: its phase, size or place.
const Names& of_first_sensor() {
  static const Names names{"sensor turned over",
                           "sensors exchanged",
                           "sensor delayed",
                           "one sensor off by a factor",
                           "velocity for acceleration",
                           "displacement for acceleration"};
  return names;
}

const Names& between_sensors() {
  static const Names names{"sensor turned over in one run",
                           "range changed in one run",
                           "range changed from a run on",
                           "sensor moved from a run on",
                           "one sensor's sensitivity off by 1000",
                           "sensor drifts",
                           "response clipped",
                           "cable off in one run"};
  return names;
}

const Names& recorded_anew() {
  static const Names names{"run of another structure",
                           "structure changed in one run",
                           "structure warms up",
                           "sensor moved from a run on"};
  return names;
}

const Names& on_all_frfs() {
  static const Names names{"hammer in kN declared N", "sensors off by a unit"};
  return names;
}

bool removes(const std::string& one, const std::string& other) {
  if (one == "hammer without signal") return true;
  if (without_hits().contains(one) && !in_the_samples().contains(other)) {
    return true;
  }
  if (one == "cable off" && (of_first_sensor().contains(other) ||
                             between_sensors().contains(other))) {
    return true;
  }
  return other_kind().contains(one) && of_first_sensor().contains(other);
}

}  // namespace

bool go_together(const Mistake& one, const Mistake& other) {
  if (one.name == other.name) return false;
  const auto both = [&](const Names& names) {
    return names.contains(one.name) && names.contains(other.name);
  };
  return !removes(one.name, other.name) && !removes(other.name, one.name) &&
         !both(recorded_anew()) && !both(on_all_frfs());
}

void make_both(const Mistake& one,
               const Mistake& other,
               SheetAndRecords& test,
               const PlainOptions& options,
               double size,
               double other_size) {
  // What is recorded anew first, the copy of a run last.
  const auto order = [](const Mistake& mistake) {
    if (recorded_anew().contains(mistake.name)) return 0;
    return mistake.name == "run listed twice" ? 2 : 1;
  };
  const bool last = order(other) < order(one);
  if (last) other.make(test, options, other_size);
  one.make(test, options, size);
  if (!last) other.make(test, options, other_size);
}

}  // namespace tapfit::updating::testing
