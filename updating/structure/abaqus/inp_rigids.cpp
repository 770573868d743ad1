// *RIGID BODY, *KINEMATIC COUPLING, *COUPLING with *KINEMATIC: RBE2; *COUPLING
// with *DISTRIBUTING: RBE3; *DISTRIBUTING COUPLING: MPC.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::structure {
namespace {

const char* const all_dofs = "123456";

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
  CardFields fields{deck.next_element++, lead, components};
  fields.insert(fields.end(), follow.begin(), follow.end());
  deck.cards.card(place, "RBE2", fields);
}

// A node of its own in the middle of others.
int add_middle(InpDeck& deck,
               const Keyword& keyword,
               const std::vector<int>& nodes) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int id : nodes) {
    middle +=
        deck.node(id, keyword.place).at / static_cast<double>(nodes.size());
  }
  CardFields fields{deck.next_grid, ""};
  add_vector(fields, middle);
  deck.cards.card(keyword.place, "GRID", fields);
  return deck.next_grid++;
}

// The nodes that options name, if given.
std::vector<int> named_nodes(const InpDeck& deck,
                             const Keyword& keyword,
                             const std::vector<std::string>& options) {
  std::vector<int> nodes;
  for (const std::string& option : options) {
    const std::string set = keyword.option(option);
    if (set.empty()) continue;
    const std::vector<int> ids = deck.nodes_of(set, keyword.place);
    nodes.insert(nodes.end(), ids.begin(), ids.end());
  }
  return nodes;
}

// Nodes of NSET and ELSET follow in all six, those of PIN NSET in three.
void write_rigid_body(InpDeck& deck, const Keyword& keyword) {
  std::vector<int> nodes = named_nodes(deck, keyword, {"NSET", "TIENSET"});
  std::vector<int> pinned = named_nodes(deck, keyword, {"PINNSET"});
  if (keyword.has("ELSET")) {
    for (const std::size_t k : deck.element_set(keyword)) {
      const std::vector<int>& own = deck.elements[k].nodes;
      nodes.insert(nodes.end(), own.begin(), own.end());
    }
  }
  if (nodes.empty() && pinned.empty()) {
    keyword.fail("the rigid body has no node",
                 "Name NSET or ELSET; analytical surfaces are not read.");
  }
  const int lead =
      keyword.has("REFNODE")
          ? deck.one_node(keyword, "REFNODE")
          : add_middle(deck, keyword, nodes.empty() ? pinned : nodes);
  if (keyword.has("ROTNODE")) {
    const auto turning =
        deck.turning_node.find(deck.one_node(keyword, "ROTNODE"));
    if (turning != deck.turning_node.end()) turning->second = lead;
  }
  for (const int id : nodes) std::erase(pinned, id);
  write_rbe2(deck, keyword.place, lead, all_dofs, nodes);
  write_rbe2(deck, keyword.place, lead, "123", pinned);
}

void refuse_turned(const Keyword& keyword) {
  if (!keyword.has("ORIENTATION")) return;
  keyword.fail("a coupling along axes of its own is not read",
               "Leave ORIENTATION out, or turn its nodes by *TRANSFORM.");
}

// All of them where none is given.
std::string coupled_dofs(const DataLine& line, std::size_t field) {
  return line.text(field).empty() ? all_dofs : dofs_in(line, field);
}

void write_kinematic_coupling(InpDeck& deck, const Keyword& keyword) {
  refuse_turned(keyword);
  const int lead = deck.one_node(keyword, "REFNODE");
  for (const DataLine& line : keyword.lines) {
    write_rbe2(deck,
               line.place,
               lead,
               coupled_dofs(line, 1),
               deck.nodes_of(line.text(0), line.place));
  }
}

// *COUPLING, and the *KINEMATIC or *DISTRIBUTING that follows it.
void write_coupling(InpDeck& deck,
                    const Keyword& coupling,
                    const Keyword& kind) {
  refuse_turned(coupling);
  const int lead = deck.one_node(coupling, "REFNODE");
  std::vector<int> nodes = named_in(deck.surfaces,
                                    coupling.needed_option("SURFACE"),
                                    "surface",
                                    coupling.place)
                               .nodes;
  std::erase(nodes, lead);
  std::string components = kind.lines.empty() ? all_dofs : "";
  for (const DataLine& line : kind.lines) components += coupled_dofs(line, 0);
  std::ranges::sort(components);
  components.erase(std::unique(components.begin(), components.end()),
                   components.end());
  if (kind.name == "KINEMATIC") {
    write_rbe2(deck, coupling.place, lead, components, nodes);
    return;
  }
  deck.say(kind.place.where +
           ": all nodes of *DISTRIBUTING count alike, whatever their share of "
           "the surface");
  CardFields fields{deck.next_element++, "", lead, components, 1.0, "123"};
  fields.insert(fields.end(), nodes.begin(), nodes.end());
  deck.cards.card(coupling.place, "RBE3", fields);
}

// The element's node moves as the weighted mean of the others, without their
// turning, as in CalculiX.
void write_distributing_coupling(InpDeck& deck, const Keyword& keyword) {
  refuse_turned(keyword);
  const auto own = section_elements(deck, keyword, {InpFamily::Distributing});
  if (own.size() != 1) {
    keyword.fail(fmt::format("its set holds {} elements DCOUP3D", own.size()),
                 "Name an ELSET of one, whose node the others lead.");
  }
  InpElement& element = deck.elements[own.front()];
  element.property = 1;
  std::vector<std::pair<int, double>> leads;
  double sum = 0.0;
  for (const DataLine& line : keyword.lines) {
    const double weight = number_or(line, 1, 1.0, "weight");
    for (const int node : deck.nodes_of(line.text(0), line.place)) {
      leads.emplace_back(node, weight);
      sum += weight;
    }
  }
  if (!(sum > 0.0)) {
    keyword.fail("its weights add up to nothing",
                 "Name nodes with weights above zero.");
  }
  for (int dof = 1; dof <= 3; ++dof) {
    std::vector<RelationTerm> terms{{element.nodes[0], dof, -1.0}};
    for (const auto& [node, weight] : leads) {
      terms.push_back({node, dof, weight / sum});
    }
    write_relation(deck, keyword.place, terms);
  }
  deck.say(keyword.place.where +
           ": the node of *DISTRIBUTING COUPLING moves as the mean of the "
           "others, as in CalculiX; Abaqus turns it with them");
}

}  // namespace

void find_turning_nodes(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("RIGIDBODY")) {
    if (!keyword->has("ROTNODE")) continue;
    const int turning = deck.one_node(*keyword, "ROTNODE");
    const bool other = !keyword->has("REFNODE") ||
                       deck.one_node(*keyword, "REFNODE") != turning;
    if (other) deck.turning_node[turning] = 0;
  }
}

void write_inp_rigids(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("RIGIDBODY")) {
    write_rigid_body(deck, *keyword);
  }
  for (const Keyword* keyword : deck.of("KINEMATICCOUPLING")) {
    write_kinematic_coupling(deck, *keyword);
  }
  for (const Keyword* keyword : deck.of("DISTRIBUTINGCOUPLING")) {
    write_distributing_coupling(deck, *keyword);
  }
  for (const InpElement& e : deck.elements) {
    if (!e.is(InpFamily::Distributing) || e.property != 0) continue;
    fail_at(e.place,
            fmt::format("element {} ({}) has no coupling", e.id, e.type_name),
            "Name a set with it in *DISTRIBUTING COUPLING.");
  }
  const Keyword* coupling = nullptr;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "COUPLING") coupling = &keyword;
    if (keyword.name != "KINEMATIC" && keyword.name != "DISTRIBUTING") continue;
    if (coupling == nullptr) {
      keyword.fail("no *COUPLING stands above it",
                   "Put it below the *COUPLING that it belongs to.");
    }
    write_coupling(deck, *coupling, keyword);
    coupling = nullptr;
  }
}

}  // namespace tapfit::structure
