// *BOUNDARY: SPC1. Those of the model and of the steps up to and with the first
// that asks for modes hold; OP=NEW takes back what was said before.
#include "updating/structure/abaqus/inp_deck.hpp"

namespace tapfit::structure {
namespace {

struct Hold {
  Place place;
  std::string components;
  std::vector<int> nodes;
};

// Components held; names may stand in place of degrees of freedom.
std::string components_of(InpDeck& deck, const DataLine& line) {
  static const std::map<std::string, std::string> names{{"ENCASTRE", "123456"},
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
  const auto named = names.find(line.name(1));
  if (named != names.end()) return named->second;
  if (number_or(line, 3, 0.0, "value") != 0.0) {
    deck.say(line.place.where +
             ": a displacement that is given is taken as zero");
  }
  return dofs_in(line, 1);
}

// What the turning node of a rigid body is held in, the other one is.
void add_hold(const InpDeck& deck, Hold hold, std::vector<Hold>& holds) {
  std::erase_if(hold.nodes, [&](int id) {
    const auto body = deck.turning_node.find(id);
    if (body == deck.turning_node.end()) return false;
    Hold turned{hold.place, "", {body->second}};
    for (const char c : hold.components) {
      if (c <= '3') turned.components += static_cast<char>(c + 3);
    }
    if (!turned.components.empty()) holds.push_back(turned);
    return true;
  });
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
      std::string components = components_of(deck, line);
      add_hold(deck,
               {line.place,
                std::move(components),
                deck.nodes_of(line.text(0), line.place)},
               holds);
    }
  }
  for (const Hold& hold : holds) {
    CardFields fields{1, hold.components};
    fields.insert(fields.end(), hold.nodes.begin(), hold.nodes.end());
    deck.cards.card(hold.place, "SPC1", fields);
  }
}

}  // namespace tapfit::structure
