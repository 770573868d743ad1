#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

using Sets = std::map<std::string, std::vector<int>>;

struct Name {
  std::string whole;
  std::string last;  // PART-1-1.SET is SET: there is but one instance
};

Name name_in(const std::string& text) {
  const std::string whole = DataLine{{text}, {}, false}.name(0);
  const std::size_t point = whole.rfind('.');
  return {whole, point == std::string::npos ? whole : whole.substr(point + 1)};
}

const std::vector<int>* find_set(const Sets& sets, const Name& name) {
  auto found = sets.find(name.whole);
  if (found == sets.end()) found = sets.find(name.last);
  return found == sets.end() ? nullptr : &found->second;
}

[[noreturn]] void no_set(const std::string& kind,
                         const Name& name,
                         const Place& asks) {
  fail_at(asks,
          fmt::format("the {} set {} is not defined",
                      kind,
                      name.whole.empty() ? "\"\"" : shortened(name.whole)),
          fmt::format("Define it by *{0}SET, {0}SET=..., or correct the name.",
                      kind == "node" ? "N" : "EL"));
}

// Ids of a set, or the id itself.
template <typename Index>
std::vector<int> ids_of(const Sets& sets,
                        const Index& known,
                        const std::string& kind,
                        const std::string& text,
                        const Place& asks) {
  const Name name = name_in(text);
  const std::optional<int> id = integer_of(name.last);
  const std::vector<int>* set = find_set(sets, name);
  if (set != nullptr && id && known.contains(*id)) {
    fail_at(asks,
            fmt::format("{} is a set and the id of one {}", *id, kind),
            "Give the set a name that begins with a letter.");
  }
  if (set != nullptr) return *set;
  if (!id) no_set(kind, name, asks);
  return {*id};
}

std::vector<std::size_t> places_of(const InpDeck& deck,
                                   const std::vector<int>& ids,
                                   const Place& asks) {
  std::vector<std::size_t> places;
  for (const int id : ids) {
    const auto found = deck.element_index.find(id);
    if (found == deck.element_index.end()) {
      fail_at(asks,
              fmt::format("element {} is not defined", id),
              "Add it to an *ELEMENT, or correct the id.");
    }
    places.push_back(found->second);
  }
  return places;
}

}  // namespace

const InpNode& InpDeck::node(int id, const Place& asks) const {
  const auto found = node_index.find(id);
  if (found == node_index.end()) {
    fail_at(asks,
            fmt::format("node {} is not defined", id),
            "Add it to a *NODE, or correct the id.");
  }
  return nodes[found->second];
}

std::vector<int> InpDeck::nodes_of(const std::string& text,
                                   const Place& asks) const {
  std::vector<int> ids = ids_of(node_sets, node_index, "node", text, asks);
  for (const int id : ids) static_cast<void>(node(id, asks));
  return ids;
}

int InpDeck::one_node(const Keyword& keyword, const std::string& option) const {
  const std::vector<int> ids =
      nodes_of(keyword.needed_option(option), keyword.place);
  if (ids.size() != 1) {
    keyword.fail(fmt::format("{} names {} nodes", option, ids.size()),
                 "Name one.");
  }
  return ids.front();
}

std::vector<std::size_t> InpDeck::elements_of(const std::string& text,
                                              const Place& asks) const {
  return places_of(
      *this, ids_of(element_sets, element_index, "element", text, asks), asks);
}

std::vector<std::size_t> InpDeck::element_set(const Keyword& keyword) const {
  const Name name = name_in(keyword.needed_option("ELSET"));
  const std::vector<int>* set = find_set(element_sets, name);
  if (set == nullptr) no_set("element", name, keyword.place);
  return places_of(*this, *set, keyword.place);
}

std::vector<const Keyword*> InpDeck::of(const std::string& name) const {
  std::vector<const Keyword*> found;
  for (const Keyword& keyword : keywords) {
    if (keyword.step == 0 && keyword.name == name) found.push_back(&keyword);
  }
  return found;
}

void InpDeck::say(const std::string& text) {
  if (std::ranges::find(warnings, text) == warnings.end()) {
    warnings.push_back(text);
  }
}

void InpDeck::leave_out(const std::string& name,
                        const Place& place,
                        const std::string& consequence) {
  LeftOutCount& seen = left_out[shortened(name)];
  if (seen.count++ == 0) {
    seen.place = place;
    seen.consequence = consequence;
  }
}

void InpDeck::name_card(const std::string& card,
                        int id,
                        const std::string& name,
                        const Place& place) {
  named.push_back(fmt::format("{} {} is {}", card, id, name));
  cards.comment(named.back(), place);
}

}  // namespace tapfit::structure
