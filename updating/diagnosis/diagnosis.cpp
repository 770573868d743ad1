#include "updating/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {

bool is_significant(const NextMeasurement& next, double floor) {
  return next.difference > std::max(floor, 2.0 * next.difference_now);
}

std::string advice(const NextMeasurement& next, double floor) {
  if (!is_significant(next, floor)) {
    return fmt::format(
        "no hit or sensor point would tell them apart (at best {:.2g} % "
        "between their predictions, the floor is {:.2g} %)",
        100.0 * next.difference,
        100.0 * floor);
  }
  return fmt::format(
      "hit {}, {} {} {}: predictions differ by {:.2g} % there, "
      "so far by {:.2g} %",
      name(next.hit),
      next.moves_sensor ? "move" : "with",
      next.channel,
      (next.moves_sensor ? "to " : "at ") + name(next.sensor),
      100.0 * next.difference,
      100.0 * next.difference_now);
}

}  // namespace tapfit::updating
