#include "updating/structure/abaqus/inp_deck.hpp"

#include "acquisition/foundation/trimmed_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

// PART-1-1.SET is SET: there is but one instance.
std::string bare(const std::string& text) {
  std::string name = upper(trimmed(text));
  std::erase(name, '"');
  return name;
}

const std::vector<int>* find_set(
    const std::map<std::string, std::vector<int>>& sets,
    const std::string& name) {
  auto found = sets.find(name);
  if (found == sets.end()) {
    const std::size_t point = name.rfind('.');
    if (point == std::string::npos) return nullptr;
    found = sets.find(name.substr(point + 1));
  }
  return found == sets.end() ? nullptr : &found->second;
}

[[noreturn]] void no_set(const char* kind,
                         const std::string& name,
                         const Place& asks) {
  constexpr std::size_t most = 40;
  fail_at(asks,
          fmt::format("the {} set {} is not defined",
                      kind,
                      name.empty() ? "\"\"" : name.substr(0, most)),
          fmt::format("Define it by *{0}SET, {0}SET=..., or correct the name.",
                      kind == std::string("node") ? "N" : "EL"));
}

// 17, or PART-1-1.17.
std::optional<int> id_in(const std::string& name) {
  const std::size_t point = name.rfind('.');
  return integer_of(point == std::string::npos ? name : name.substr(point + 1));
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
  const std::string name = bare(text);
  if (const std::vector<int>* set = find_set(node_sets, name)) return *set;
  const std::optional<int> id = id_in(name);
  if (!id) no_set("node", name, asks);
  return {node(*id, asks).id};
}

std::vector<std::size_t> InpDeck::elements_of(const std::string& text,
                                              const Place& asks) const {
  const std::string name = bare(text);
  std::vector<int> ids;
  if (const std::vector<int>* set = find_set(element_sets, name)) {
    ids = *set;
  } else if (const std::optional<int> id = id_in(name)) {
    ids = {*id};
  } else {
    no_set("element", name, asks);
  }
  std::vector<std::size_t> places;
  for (const int id : ids) {
    const auto found = element_index.find(id);
    if (found == element_index.end()) {
      fail_at(asks,
              fmt::format("element {} is not defined", id),
              "Add it to an *ELEMENT, or correct the id.");
    }
    places.push_back(found->second);
  }
  return places;
}

std::vector<const Keyword*> InpDeck::of(const std::string& name) const {
  std::vector<const Keyword*> found;
  for (const Keyword& keyword : keywords) {
    if (keyword.step == 0 && keyword.name == name) found.push_back(&keyword);
  }
  return found;
}

void say(InpDeck& deck, const std::string& text) {
  if (std::ranges::find(deck.warnings, text) == deck.warnings.end()) {
    deck.warnings.push_back(text);
  }
}

void count_left_out(LeftOutCounts& counts,
                    const std::string& name,
                    const Place& place,
                    const std::string& consequence) {
  LeftOutCount& seen = counts[name];
  if (seen.count++ == 0) {
    seen.place = place;
    seen.consequence = consequence;
  }
}

void add_left_out(InpDeck& deck, const LeftOutCounts& counts) {
  for (const auto& [name, seen] : counts) {
    deck.left_out.push_back({name,
                             seen.place.where,
                             fmt::format("{} (line {}, {} in all) is not read: "
                                         "{}",
                                         name,
                                         seen.place.number,
                                         seen.count,
                                         seen.consequence)});
  }
}

}  // namespace tapfit::structure
