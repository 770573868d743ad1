// *BOUNDARY: SPC1. Those of the model and of the steps up to and with the first
// that asks for modes hold; OP=NEW takes back what was said before.
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tapfit::structure {
namespace {

struct Hold {
  Place place;
  std::string components;
  std::vector<int> nodes;
};

// Names in place of degrees of freedom; nullptr for none of them.
const char* named_support(const std::string& name) {
  static const std::map<std::string, const char*> names{{"ENCASTRE", "123456"},
                                                        {"PINNED", "123"},
                                                        {"XSYMM", "156"},
                                                        {"YSYMM", "246"},
                                                        {"ZSYMM", "345"},
                                                        {"XASYMM", "234"},
                                                        {"YASYMM", "135"},
                                                        {"ZASYMM", "126"},
                                                        {"NOWARP", ""},
                                                        {"NOOVAL", ""},
                                                        {"NODEFORM", ""}};
  const auto found = names.find(name);
  return found == names.end() ? nullptr : found->second;
}

std::string components_of(InpDeck& deck, const DataLine& line) {
  const std::string name = upper(line.text(1));
  if (const char* known = named_support(name)) return known;
  const int first = integer_in(line, 1, "first degree of freedom");
  const int last = line.text(2).empty()
                       ? first
                       : integer_in(line, 2, "last degree of freedom");
  if (first < 1 || last < first) {
    fail_at(line.place,
            fmt::format("{} to {} are no degrees of freedom", first, last),
            "Give the smaller one first, 1 to 6.");
  }
  if (number_or(line, 3, 0.0, "value") != 0.0) {
    say(deck,
        line.place.where + ": a displacement that is given is taken as zero");
  }
  std::string digits;
  // Beyond 6: warping, pressure, temperature.
  for (int dof = first; dof <= std::min(last, 6); ++dof) {
    digits += static_cast<char>('0' + dof);
  }
  return digits;
}

// What the turning node of a rigid body is held in, the other one is.
void add_hold(const InpDeck& deck, Hold hold, std::vector<Hold>& holds) {
  std::vector<int> plain;
  for (const int id : hold.nodes) {
    const auto body = deck.turning_node.find(id);
    if (body == deck.turning_node.end()) {
      plain.push_back(id);
      continue;
    }
    Hold turned{hold.place, "", {body->second}};
    for (const char c : hold.components) {
      if (c <= '3') turned.components += static_cast<char>(c + 3);
    }
    if (!turned.components.empty()) holds.push_back(turned);
  }
  hold.nodes = std::move(plain);
  if (!hold.nodes.empty() && !hold.components.empty()) holds.push_back(hold);
}

}  // namespace

void write_inp_boundary(InpDeck& deck) {
  std::vector<Hold> holds;
  int cleared = 0;  // the last step that began anew
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.name != "BOUNDARY" || keyword.step > deck.last_step) continue;
    if (keyword.option("OP") == "NEW" && cleared != keyword.step) {
      holds.clear();
      cleared = keyword.step;
    }
    for (const DataLine& line : keyword.lines) {
      Hold hold{line.place, components_of(deck, line), {}};
      hold.nodes = deck.nodes_of(line.text(0), line.place);
      add_hold(deck, std::move(hold), holds);
    }
  }
  for (const Hold& hold : holds) {
    std::vector<std::string> fields{"1", hold.components};
    for (const int id : hold.nodes) fields.push_back(fmt::format("{}", id));
    deck.cards.card(hold.place, "SPC1", fields);
  }
}

}  // namespace tapfit::structure
