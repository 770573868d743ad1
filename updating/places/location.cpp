#include "updating/places/location.hpp"

#include "acquisition/foundation/dof.hpp"

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

// A row of them by its ends.
std::string runs_text(const std::vector<int>& runs) {
  if (runs.size() == 1) return fmt::format("run {}", runs.front());
  const auto length = static_cast<std::size_t>(runs.back() - runs.front()) + 1;
  if (length == runs.size()) {
    return fmt::format("runs {} to {}", runs.front(), runs.back());
  }
  return fmt::format("runs {}", fmt::join(runs, ", "));
}

// Channels of the sheet, and at which of its grids.
std::string on_sheet(const Location& where) {
  std::string text = fmt::format("{}", fmt::join(where.channels, ", "));
  if (where.node != 0) text += " at node " + node_name(where.node);
  if (where.node != 0 && !where.nodes.empty()) text += ", not";
  if (where.node == 0 && !where.nodes.empty()) text += " at node";
  for (const int grid : where.nodes) {
    text += (grid == where.nodes.front() ? " " : ", ") + node_name(grid);
  }
  return text;
}

}  // namespace

bool is_at_grid(const Location& where) {
  return where.node != 0 && where.channels.empty();
}

bool takes_mass(const Location& where) {
  return where.variant == pocket || where.variant == pocket_edges;
}

bool has_edges(const Location& where) {
  return where.variant == edges || where.variant == pocket_edges;
}

bool is_along_axis(const Location& where) {
  return where.variant == "X" || where.variant == "Y" || where.variant == "Z";
}

bool is_direction(const Location& where) {
  const std::string& v = where.variant;
  return v.size() == 2 && (v[0] == '+' || v[0] == '-') && v[1] >= 'X' &&
         v[1] <= 'Z';
}

std::string describe(const Location& where) {
  const std::string variant = where.variant.empty() ? ""
                              : is_along_axis(where) || is_direction(where)
                                  ? fmt::format(" along {}", where.variant)
                                  : fmt::format(" ({})", where.variant);
  if (!where.channels.empty()) {
    const std::string text = on_sheet(where) + variant;
    return where.runs.empty() ? text : text + ", in " + runs_text(where.runs);
  }
  if (where.node != 0) {
    return fmt::format(
        "{}node {}{}", where.at.empty() ? "" : "near ", where.node, variant);
  }
  if (!where.elements.empty())
    return named("element", where.elements) + variant;
  if (!where.nodes.empty()) return named("node", where.nodes) + variant;
  if (!where.runs.empty()) return runs_text(where.runs);
  return "everywhere" + variant;
}

}  // namespace tapfit::updating
