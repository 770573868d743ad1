#include "updating/diagnosis/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

// A few one by one, many by the first and the last.
std::string named(const char* what, const std::vector<int>& ids) {
  constexpr std::size_t few = 3;
  if (ids.size() == 1) return fmt::format("{} {}", what, ids.front());
  if (ids.size() <= few) {
    return fmt::format("{}s {}", what, fmt::join(ids, ", "));
  }
  return fmt::format(
      "{} {}s ({} ... {})", ids.size(), what, ids.front(), ids.back());
}

}  // namespace

std::string describe(const Where& where) {
  const std::string variant =
      where.variant.empty() ? "" : fmt::format(" ({})", where.variant);
  if (where.node != 0) return fmt::format("node {}", where.node) + variant;
  if (!where.channels.empty()) {
    return fmt::format("{}", fmt::join(where.channels, ", ")) + variant;
  }
  if (!where.elements.empty())
    return named("element", where.elements) + variant;
  if (!where.nodes.empty()) return named("node", where.nodes) + variant;
  return "everywhere" + variant;
}

std::string leading_kind(const Rung& rung) {
  return rung.added.substr(0, rung.added.find('|'));
}

bool is_telling(const NextMeasurement& next, double floor) {
  return next.difference > std::max(floor, 2.0 * next.difference_now);
}

std::string advice(const NextMeasurement& next, double floor) {
  if (!is_telling(next, floor)) {
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
