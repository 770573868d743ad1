#include "updating/diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapfit::updating {

std::string describe(const Where& where) {
  const std::string variant =
      where.variant.empty() ? "" : fmt::format(" ({})", where.variant);
  if (where.node != 0) return fmt::format("node {}", where.node) + variant;
  if (!where.channels.empty()) {
    return fmt::format("{}", fmt::join(where.channels, ", ")) + variant;
  }
  if (!where.elements.empty()) {
    return fmt::format("{} elements ({} ... {})",
                       where.elements.size(),
                       where.elements.front(),
                       where.elements.back()) +
           variant;
  }
  if (!where.nodes.empty()) {
    return fmt::format("{} nodes ({} ... {})",
                       where.nodes.size(),
                       where.nodes.front(),
                       where.nodes.back()) +
           variant;
  }
  return "everywhere" + variant;
}

std::string leading_kind(const Rung& rung) {
  return rung.added.substr(0, rung.added.find('|'));
}

}  // namespace tapfit::updating
