#include "updating/structure/edit/hold_cards.hpp"

#include "updating/structure/cards/case_control.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>

namespace tapfit::structure {
namespace {

// The number in the first line that is like this.
std::optional<int> first_number(const Deck& deck, const std::regex& like) {
  for (const std::string& line : deck.cards) {
    std::smatch found;
    if (std::regex_search(line, found, like)) return std::stoi(found[1]);
  }
  return std::nullopt;
}

// Components along the grid's own axes; empty where they are askew to these.
std::string along_own_axes(const Deck& deck, const Constraint& held) {
  // All three of a kind are so along whatever axes.
  const auto whole = [&held](const char* kind) {
    return held.components.find(kind) != std::string::npos;
  };
  std::string own;
  for (const char digit : held.components) {
    if (whole(digit <= '3' ? "123" : "456")) {
      own += digit;
      continue;
    }
    const auto component = card_component(deck, held.grid, digit - '0');
    if (!component) return {};
    own += static_cast<char>('0' + *component);
  }
  return own;
}

// In free field, eight fields to a line.
std::vector<std::string> spc1_lines(int set,
                                    const std::string& components,
                                    const std::vector<int>& grids) {
  std::vector<std::string> lines;
  std::string line = fmt::format("SPC1,{},{}", set, components);
  int fields = 2;
  for (const int grid : grids) {
    if (fields == 8) {
      lines.push_back(line);
      line.clear();
      fields = 0;
    }
    line += fmt::format(",{}", grid);
    ++fields;
  }
  lines.push_back(line);
  return lines;
}

}  // namespace

int constraint_set(const Deck& deck) {
  if (const auto set = case_control(deck.cards).spc_set) return *set;
  const std::regex card(R"(^SPC1?\*?[\s,]+(\d{1,8})\b)", std::regex::icase);
  return first_number(deck, card).value_or(1);
}

std::vector<std::string> hold_cards(const Deck& deck,
                                    const std::vector<Constraint>& held) {
  std::map<std::string, std::vector<int>> alike;
  std::vector<std::string> cards;
  for (const Constraint& grid : held) {
    const std::string own = along_own_axes(deck, grid);
    if (!own.empty()) {
      alike[own].push_back(grid.grid);
      continue;
    }
    cards.push_back(fmt::format(
        "$ grid {}: no component along its axes (CD) is the one held; give it "
        "CD 0, then hold component {}",
        grid.grid,
        grid.components));
  }
  const int set = constraint_set(deck);
  const CaseControl control = case_control(deck.cards);
  if (!alike.empty() && control.selects && !control.spc_set) {
    cards.push_back(
        fmt::format("$ choose SPC = {} in the case control, without which what "
                    "follows does not hold",
                    set));
  }
  for (const auto& [components, grids] : alike) {
    for (std::string& line : spc1_lines(set, components, grids)) {
      cards.push_back(std::move(line));
    }
  }
  return cards;
}

}  // namespace tapfit::structure
