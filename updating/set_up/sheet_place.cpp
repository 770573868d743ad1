#include "updating/set_up/sheet_place.hpp"

#include "acquisition/foundation/dof.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace tapfit::effects {
namespace {

std::optional<int> number_in(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number <= 0) return std::nullopt;
  return number;
}

// "8", or "P3" of a point of the test's own.
std::optional<int> grid_in(std::string_view text) {
  const bool own = text.starts_with('P');
  const std::optional<int> number = number_in(text.substr(own ? 1 : 0));
  if (!number) return std::nullopt;
  return own ? -*number : *number;
}

// "run4" or "run4-6"; nothing where it is neither.
std::vector<int> runs_in(std::string_view text) {
  constexpr std::string_view word = "run";
  if (!text.starts_with(word)) return {};
  text.remove_prefix(word.size());
  const std::size_t dash = text.find('-');
  const auto first = number_in(text.substr(0, dash));
  const auto last =
      dash == std::string_view::npos ? first : number_in(text.substr(dash + 1));
  std::vector<int> runs;
  constexpr int most = 100000;
  if (!first || !last || *last > most) return runs;
  for (int run = *first; run <= *last; ++run) runs.push_back(run);
  return runs;
}

std::string runs_text(const std::vector<int>& runs) {
  std::string text;
  for (std::size_t k = 0; k < runs.size();) {
    std::size_t last = k;
    while (last + 1 < runs.size() && runs[last + 1] == runs[last] + 1) ++last;
    text += fmt::format(":run{}", runs[k]);
    if (last > k) text += fmt::format("-{}", runs[last]);
    k = last + 1;
  }
  return text;
}

}  // namespace

Location read_sheet_place(std::vector<std::string> parts,
                          const Effect& effect) {
  Location where;
  while (!parts.empty()) {
    const std::vector<int> runs = runs_in(parts.back());
    if (runs.empty()) break;
    where.runs.insert(where.runs.end(), runs.begin(), runs.end());
    parts.pop_back();
  }
  std::ranges::sort(where.runs);
  const auto doubled = std::ranges::unique(where.runs);
  where.runs.erase(doubled.begin(), doubled.end());
  const auto take_grid = [&parts]() -> std::optional<int> {
    // A number alone is a channel's name.
    if (parts.size() < 2) return std::nullopt;
    const std::optional<int> grid = grid_in(parts.back());
    if (grid) parts.pop_back();
    return grid;
  };
  const std::vector<std::string> known = effect.variants();
  if (!parts.empty() && std::ranges::find(known, parts.back()) != known.end()) {
    where.variant = parts.back();
    parts.pop_back();
  }
  if (effect.takes_any_grid()) {
    const bool open = parts.size() > 1 && parts.back().empty();
    if (open) parts.pop_back();
    where.node = open ? 0 : take_grid().value_or(0);
  }
  if (const auto grid = take_grid()) where.nodes = {*grid};
  where.channels = std::move(parts);
  return where;
}

std::string sheet_place_text(const Location& where) {
  std::string text = fmt::format("{}", fmt::join(where.channels, ":"));
  if (!where.nodes.empty()) text += ":" + node_name(where.nodes.front());
  if (where.node != 0) text += ":" + node_name(where.node);
  if (!where.variant.empty()) text += ":" + where.variant;
  const bool open =
      !where.nodes.empty() && where.node == 0 && where.variant.empty();
  if (open) text += ":";
  return text + runs_text(where.runs);
}

}  // namespace tapfit::effects
