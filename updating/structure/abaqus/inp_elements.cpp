// *ELEMENT: read with their nodes, written once they have sections.
#include "acquisition/foundation/coordinate_system.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

// Nodes of a type that is not read: all on lines that end in a comma.
InpElement next_element(const Keyword& keyword,
                        std::size_t& k,
                        const InpType* type,
                        std::size_t most) {
  const DataLine& first = keyword.lines[k];
  InpElement e;
  e.id = integer_in(first, 0, "element");
  e.type = type;
  e.place = first.place;
  const auto take = [&e](const DataLine& line, std::size_t from) {
    for (std::size_t at = from; at < line.fields.size(); ++at) {
      if (!line.text(at).empty()) {
        e.nodes.push_back(integer_in(line, at, "node"));
      }
    }
  };
  take(first, 1);
  while (keyword.lines[k].continues && k + 1 < keyword.lines.size() &&
         (type == nullptr || e.nodes.size() < most)) {
    take(keyword.lines[++k], 0);
  }
  ++k;
  return e;
}

// Of a beam one more, for its direction 1.
std::size_t most_nodes(const InpType& type) {
  return type.nodes + (type.family == InpFamily::Beam ? 1 : 0);
}

// CalculiX passes over what stands behind the last node of a type.
void check_nodes(InpDeck& deck, InpElement& e) {
  const std::size_t needed = e.type->nodes;
  if (e.nodes.size() < needed) {
    fail_at(e.place,
            fmt::format("element {} has {} nodes, {} has {}",
                        e.id,
                        e.nodes.size(),
                        e.type_name,
                        needed),
            "Correct its line; one that goes on in the next ends in a comma.");
  }
  if (e.nodes.size() > most_nodes(*e.type)) {
    say(deck,
        fmt::format("elements of type {} name more than {} nodes: those behind "
                    "are left out",
                    e.type_name,
                    needed));
    e.nodes.resize(needed);
  }
  for (const int id : e.nodes) static_cast<void>(deck.node(id, e.place));
}

void add_element(InpDeck& deck, InpElement e, const std::string& set) {
  if (e.id <= 0 || e.id > largest_inp_id) {
    fail_at(
        e.place,
        fmt::format("the element id {} is not above zero, or too large", e.id),
        "Correct the id.");
  }
  const auto [known, fresh] =
      deck.element_index.try_emplace(e.id, deck.elements.size());
  if (!fresh) {
    fail_at(e.place,
            fmt::format("element {} is defined already in {}",
                        e.id,
                        deck.elements[known->second].place.where),
            "Renumber one of the two, or take it out.");
  }
  deck.next_element = std::max(deck.next_element, e.id + 1);
  if (!set.empty()) deck.element_sets[set].push_back(e.id);
  deck.elements.push_back(std::move(e));
}

// Grids of the element's card, property in front.
std::vector<std::string> head(const InpElement& e) {
  std::vector<std::string> fields{fmt::format("{}", e.id),
                                  fmt::format("{}", e.property)};
  for (const std::size_t at : e.type->order) {
    fields.push_back(fmt::format("{}", e.nodes[at]));
  }
  return fields;
}

// Both ends; a middle node of a truss joins nothing.
void write_truss(InpDeck& deck, const InpElement& e) {
  if (e.type->nodes > 2) {
    say(deck, e.type_name + ": the middle node of a truss is left out");
  }
  deck.cards.card(e.place,
                  "CROD",
                  {fmt::format("{}", e.id),
                   fmt::format("{}", e.property),
                   fmt::format("{}", e.nodes.front()),
                   fmt::format("{}", e.nodes[e.type->nodes - 1])});
}

}  // namespace

void read_inp_elements(InpDeck& deck) {
  LeftOutCounts counts;
  for (const Keyword* keyword : deck.of("ELEMENT")) {
    const std::string type_name = keyword->needed_option("TYPE");
    const std::string set = keyword->option("ELSET");
    const InpType* type = inp_type(type_name);
    if (!set.empty()) deck.element_sets[set];
    const std::size_t most = type == nullptr ? 0 : type->nodes;
    for (std::size_t k = 0; k < keyword->lines.size();) {
      InpElement e = next_element(*keyword, k, type, most);
      e.type_name = type_name;
      if (type == nullptr) {
        count_left_out(counts,
                       type_name,
                       e.place,
                       "these elements' stiffness and mass are missing from "
                       "the model");
      } else {
        check_nodes(deck, e);
      }
      add_element(deck, std::move(e), set);
    }
  }
  add_left_out(deck, counts);
}

void write_inp_elements(InpDeck& deck) {
  for (const InpElement& e : deck.elements) {
    if (e.type == nullptr) continue;
    const InpFamily family = e.type->family;
    const bool needs = family == InpFamily::Solid || family == InpFamily::Truss;
    if (e.property == 0) {
      fail_at(e.place,
              fmt::format("element {} ({}) has no section", e.id, e.type_name),
              "Name a set with it in *SOLID SECTION, *SHELL SECTION, *BEAM "
              "SECTION, *MASS, *SPRING or what belongs to its type.");
    }
    if (!needs) continue;  // written with their sections
    if (family == InpFamily::Truss) {
      write_truss(deck, e);
    } else {
      deck.cards.card(e.place, e.type->card, head(e));
    }
  }
}

}  // namespace tapfit::structure
