// *ELEMENT: read with their nodes, written once they have sections.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <cctype>

namespace tapfit::structure {
namespace {

// Adds the nodes of a data line from a field on. Elements of an assembly name
// those of its part with the instance: PART-1-1.5.
void take_nodes(const DataLine& line, std::size_t from, InpElement& e) {
  std::size_t end = line.fields.size();
  while (end > from && line.text(end - 1).empty()) --end;
  for (std::size_t at = from; at < end; ++at) {
    const std::string name = line.name(at);
    const std::size_t point = name.rfind('.');
    const bool of_instance =
        point != std::string::npos &&
        std::isalpha(static_cast<unsigned char>(name[0])) != 0;
    const std::optional<int> id =
        of_instance ? integer_of(name.substr(point + 1)) : std::nullopt;
    e.nodes.push_back(id ? *id : integer_in(line, at, "node"));
  }
}

// Reads lines from `k` on; of a type that is not read all that end in a comma.
InpElement next_element(const Keyword& keyword,
                        std::size_t& k,
                        const InpType* type) {
  const DataLine& first = keyword.lines[k];
  InpElement e;
  e.id = integer_in(first, 0, "element");
  e.type = type;
  e.place = first.place;
  take_nodes(first, 1, e);
  while (keyword.lines[k].continues && k + 1 < keyword.lines.size() &&
         (type == nullptr || e.nodes.size() < type->nodes)) {
    take_nodes(keyword.lines[++k], 0, e);
  }
  ++k;
  return e;
}

// A beam may name one node more, for its direction 1. CalculiX passes over what
// stands behind the last node of a type.
void check_nodes(InpDeck& deck, InpElement& e) {
  const std::size_t needed = e.type->nodes;
  const std::size_t most = needed + (e.is(InpFamily::Beam) ? 1 : 0);
  if (e.nodes.size() < needed) {
    fail_at(e.place,
            fmt::format("element {} has {} nodes, {} has {}",
                        e.id,
                        e.nodes.size(),
                        e.type_name,
                        needed),
            "Correct its line; one that goes on in the next ends in a comma.");
  }
  if (e.nodes.size() > most) {
    deck.say(
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

void write_element(InpDeck& deck, const InpElement& e) {
  CardFields fields{e.id, e.property};
  if (e.is(InpFamily::Truss)) {
    if (e.type->nodes > 2) {
      deck.say(e.type_name + ": the middle node of a truss is left out");
    }
    fields.emplace_back(e.nodes.front());
    fields.emplace_back(e.nodes[e.type->nodes - 1]);
  } else {
    for (std::size_t grid = 0; grid < e.type->nodes; ++grid) {
      fields.emplace_back(e.nodes[e.type->node_of_grid(grid)]);
    }
  }
  deck.cards.card(e.place, e.type->card, fields);
}

}  // namespace

void read_inp_elements(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("ELEMENT")) {
    const std::string type_name = keyword->needed_option("TYPE");
    const std::string set = keyword->option("ELSET");
    const InpType* type = inp_type(type_name);
    if (!set.empty()) deck.element_sets[set];
    for (std::size_t k = 0; k < keyword->lines.size();) {
      InpElement e = next_element(*keyword, k, type);
      e.type_name = type_name;
      if (type == nullptr) {
        deck.leave_out(type_name,
                       e.place,
                       "these elements' stiffness and mass are missing from "
                       "the model");
      } else {
        check_nodes(deck, e);
      }
      add_element(deck, std::move(e), set);
    }
  }
}

std::vector<std::size_t> section_elements(
    const InpDeck& deck,
    const Keyword& section,
    const std::vector<InpFamily>& families) {
  std::vector<std::size_t> found = deck.element_set(section);
  std::erase_if(found, [&](std::size_t k) {
    return std::ranges::none_of(families, [&](InpFamily family) {
      return deck.elements[k].is(family);
    });
  });
  return found;
}

int take_elements(InpDeck& deck,
                  const Keyword& section,
                  const std::vector<std::size_t>& elements,
                  const std::string& card) {
  const int id = deck.next_property++;
  for (const std::size_t k : elements) {
    InpElement& e = deck.elements[k];
    if (e.property != 0) {
      section.fail(fmt::format("element {} has a section already", e.id),
                   "Take it out of the set of one of the two.");
    }
    e.property = id;
  }
  deck.name_card(card, id, section.option("ELSET"), section.place);
  return id;
}

void write_inp_elements(InpDeck& deck) {
  const auto is_thin = [](const InpElement& e) {
    return e.is(InpFamily::Beam) || e.is(InpFamily::Shell);
  };
  if (std::ranges::any_of(deck.elements, is_thin)) {
    deck.say(
        "beams and shells stay what they are; CalculiX makes solids of them, "
        "which are stiffer in coarse meshes, and whose bars twist as if J were "
        "I11 + I22");
  }
  if (std::ranges::any_of(deck.elements, [](const InpElement& e) {
        return e.type_name == "C3D8";
      })) {
    deck.say(
        "C3D8 bends freely here, as C3D8I does; that of CalculiX locks and is "
        "stiffer where few of them are across a thickness");
  }
  for (const InpElement& e : deck.elements) {
    // What follows others has its keyword read behind all elements.
    if (e.type == nullptr || e.is(InpFamily::Distributing)) continue;
    if (e.property == 0) {
      fail_at(e.place,
              fmt::format("element {} ({}) has no section", e.id, e.type_name),
              "Name a set with it in *SOLID SECTION, *SHELL SECTION, *BEAM "
              "SECTION, *MASS, *SPRING or what belongs to its type.");
    }
    // The others are written with their sections.
    if (e.is(InpFamily::Solid) || e.is(InpFamily::Truss)) {
      write_element(deck, e);
    }
  }
}

}  // namespace tapfit::structure
