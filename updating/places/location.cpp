#include "updating/places/location.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

bool is_along_axis(const Where& where) {
  return where.variant == "X" || where.variant == "Y" || where.variant == "Z";
}

std::string describe(const Where& where) {
  const std::string variant = where.variant.empty() ? ""
                              : is_along_axis(where)
                                  ? fmt::format(" along {}", where.variant)
                                  : fmt::format(" ({})", where.variant);
  if (where.node != 0) {
    return fmt::format(
        "{}node {}{}", where.at.empty() ? "" : "near ", where.node, variant);
  }
  if (!where.channels.empty()) {
    return fmt::format("{}", fmt::join(where.channels, ", ")) + variant;
  }
  if (!where.elements.empty())
    return named("element", where.elements) + variant;
  if (!where.nodes.empty()) return named("node", where.nodes) + variant;
  return "everywhere" + variant;
}

}  // namespace tapfit::updating
