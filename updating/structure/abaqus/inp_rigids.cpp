// *RIGID BODY, *KINEMATIC COUPLING, *COUPLING with *KINEMATIC: RBE2; *COUPLING
// with *DISTRIBUTING: RBE3.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace tapfit::structure {
namespace {

const char* const all_dofs = "123456";

// The one node that an option names, by id or by a set of one.
int one_node(const InpDeck& deck,
             const Keyword& keyword,
             const std::string& option) {
  const std::vector<int> nodes =
      deck.nodes_of(keyword.needed_option(option), keyword.place);
  if (nodes.size() != 1) {
    keyword.fail(fmt::format("{} names {} nodes", option, nodes.size()),
                 "Name one.");
  }
  return nodes.front();
}

void write_rbe2(InpDeck& deck,
                const Place& place,
                int lead,
                const std::string& components,
                std::vector<int> follow) {
  std::ranges::sort(follow);
  follow.erase(std::unique(follow.begin(), follow.end()), follow.end());
  std::erase_if(follow, [&](int id) {
    return id == lead || deck.turning_node.contains(id);
  });
  if (follow.empty() || components.empty()) return;
  std::vector<std::string> fields{fmt::format("{}", deck.next_element++),
                                  fmt::format("{}", lead),
                                  components};
  for (const int id : follow) fields.push_back(fmt::format("{}", id));
  deck.cards.card(place, "RBE2", fields);
}

// A node of its own in the middle of others.
int add_middle(InpDeck& deck,
               const Keyword& keyword,
               const std::vector<int>& nodes) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int id : nodes) {
    middle += deck.node(id, keyword.place).at /
              static_cast<double>(std::max<std::size_t>(1, nodes.size()));
  }
  deck.cards.card(keyword.place,
                  "GRID",
                  {fmt::format("{}", deck.next_grid),
                   "",
                   real_field(middle.x()),
                   real_field(middle.y()),
                   real_field(middle.z())});
  return deck.next_grid++;
}

void add_named(const InpDeck& deck,
               const Keyword& keyword,
               const char* option,
               std::vector<int>& nodes) {
  const std::string set = keyword.option(option);
  if (set.empty()) return;
  const std::vector<int> ids = deck.nodes_of(set, keyword.place);
  nodes.insert(nodes.end(), ids.begin(), ids.end());
}

// Nodes of NSET and ELSET follow in all six, those of PIN NSET in three.
void write_rigid_body(InpDeck& deck, const Keyword& keyword) {
  std::vector<int> nodes;
  add_named(deck, keyword, "NSET", nodes);
  add_named(deck, keyword, "TIENSET", nodes);
  std::vector<int> pinned;
  add_named(deck, keyword, "PINNSET", pinned);
  const std::string elements = keyword.option("ELSET");
  if (!elements.empty()) {
    for (const std::size_t k : deck.elements_of(elements, keyword.place)) {
      const std::vector<int>& own = deck.elements[k].nodes;
      nodes.insert(nodes.end(), own.begin(), own.end());
    }
  }
  if (nodes.empty() && pinned.empty()) {
    keyword.fail("the rigid body has no node",
                 "Name NSET or ELSET; analytical surfaces are not read.");
  }
  const int lead = keyword.has("REFNODE") ? one_node(deck, keyword, "REFNODE")
                                          : add_middle(deck, keyword, nodes);
  if (keyword.has("ROTNODE")) {
    const auto turning =
        deck.turning_node.find(one_node(deck, keyword, "ROTNODE"));
    if (turning != deck.turning_node.end()) turning->second = lead;
  }
  for (const int id : nodes) std::erase(pinned, id);
  write_rbe2(deck, keyword.place, lead, all_dofs, nodes);
  write_rbe2(deck, keyword.place, lead, "123", pinned);
}

// First and last degree of freedom from a field on; all where none is given.
std::string dofs_in(const DataLine& line, std::size_t field) {
  if (line.text(field).empty()) return all_dofs;
  const int first = integer_in(line, field, "first degree of freedom");
  const int last = line.text(field + 1).empty()
                       ? first
                       : integer_in(line, field + 1, "last degree of freedom");
  if (first < 1 || last < first || last > 6) {
    fail_at(line.place,
            fmt::format("{} to {} are no degrees of freedom", first, last),
            "Give the smaller one first, 1 to 6.");
  }
  return std::string(all_dofs).substr(
      static_cast<std::size_t>(first) - 1,
      static_cast<std::size_t>(last - first) + 1);
}

void refuse_turned(const Keyword& keyword) {
  if (!keyword.has("ORIENTATION")) return;
  keyword.fail("a coupling along axes of its own is not read",
               "Leave ORIENTATION out, or turn its nodes by *TRANSFORM.");
}

void write_kinematic_coupling(InpDeck& deck, const Keyword& keyword) {
  refuse_turned(keyword);
  const int lead = one_node(deck, keyword, "REFNODE");
  for (const DataLine& line : keyword.lines) {
    write_rbe2(deck,
               line.place,
               lead,
               dofs_in(line, 1),
               deck.nodes_of(line.text(0), line.place));
  }
}

// What *COUPLING names; *KINEMATIC or *DISTRIBUTING follows it.
struct Coupling {
  const Keyword* keyword = nullptr;
  int lead = 0;
  std::vector<int> nodes;
};

Coupling coupling_of(const InpDeck& deck, const Keyword& keyword) {
  refuse_turned(keyword);
  Coupling c{&keyword, one_node(deck, keyword, "REFNODE"), {}};
  const std::string name = keyword.needed_option("SURFACE");
  const auto found = deck.surfaces.find(name);
  if (found == deck.surfaces.end()) {
    keyword.fail("its surface is not defined",
                 "Define it by *SURFACE, NAME=..., or correct the name.");
  }
  c.nodes = found->second.nodes;
  std::erase(c.nodes, c.lead);
  return c;
}

void write_kinematic(InpDeck& deck, const Keyword& keyword, const Coupling& c) {
  std::string components;
  for (const DataLine& line : keyword.lines) {
    for (const char dof : dofs_in(line, 0)) {
      if (components.find(dof) == std::string::npos) components += dof;
    }
  }
  if (keyword.lines.empty()) components = all_dofs;
  std::ranges::sort(components);
  write_rbe2(deck, c.keyword->place, c.lead, components, c.nodes);
}

void write_distributing(InpDeck& deck,
                        const Keyword& keyword,
                        const Coupling& c) {
  std::string components;
  for (const DataLine& line : keyword.lines) {
    for (const char dof : dofs_in(line, 0)) {
      if (components.find(dof) == std::string::npos) components += dof;
    }
  }
  if (keyword.lines.empty()) components = all_dofs;
  std::ranges::sort(components);
  say(deck,
      keyword.place.where +
          ": all nodes of *DISTRIBUTING count alike, whatever their share of "
          "the surface");
  std::vector<std::string> fields{fmt::format("{}", deck.next_element++),
                                  "",
                                  fmt::format("{}", c.lead),
                                  components,
                                  "1.",
                                  "123"};
  for (const int id : c.nodes) fields.push_back(fmt::format("{}", id));
  deck.cards.card(c.keyword->place, "RBE3", fields);
}

}  // namespace

void find_turning_nodes(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("RIGIDBODY")) {
    if (!keyword->has("ROTNODE")) continue;
    const int turning = one_node(deck, *keyword, "ROTNODE");
    const bool other = !keyword->has("REFNODE") ||
                       one_node(deck, *keyword, "REFNODE") != turning;
    if (other) deck.turning_node[turning] = 0;
  }
}

void write_inp_rigids(InpDeck& deck) {
  std::optional<Coupling> open;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    const std::string& name = keyword.name;
    if (name == "RIGIDBODY") write_rigid_body(deck, keyword);
    if (name == "KINEMATICCOUPLING") write_kinematic_coupling(deck, keyword);
    if (name == "COUPLING") open = coupling_of(deck, keyword);
    if (name == "KINEMATIC" || name == "DISTRIBUTING") {
      if (!open) {
        keyword.fail("no *COUPLING stands above it",
                     "Put it below the *COUPLING that it belongs to.");
      }
      if (name == "KINEMATIC") {
        write_kinematic(deck, keyword, *open);
      } else {
        write_distributing(deck, keyword, *open);
      }
      open.reset();
    }
  }
}

}  // namespace tapfit::structure
