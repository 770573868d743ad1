// *NODE, *TRANSFORM and *NODAL THICKNESS; GRID cards.
#include "acquisition/foundation/coordinate_system.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace tapfit::structure {
namespace {

// SYSTEM=C: coordinates are r, theta, z.
CoordinateSystem system_of(const Keyword& keyword) {
  CoordinateSystem system;
  const std::string kind = keyword.option("SYSTEM");
  if (kind == "C") system.kind = CoordinateKind::Cylindrical;
  if (!kind.empty() && kind != "C" && kind != "R") {
    keyword.fail("SYSTEM is neither R nor C",
                 "Write the nodes' places as x, y, z.");
  }
  return system;
}

void write_transform(InpDeck& deck, const Keyword& keyword) {
  const DataLine& line = keyword.line(0, "two points");
  const Eigen::Vector3d a = vector_in(line, 0, "point a");
  const Eigen::Vector3d b = vector_in(line, 3, "point b");
  const std::string type = keyword.option("TYPE");
  int system = 0;
  if (type == "C") {
    const Eigen::Vector3d along = b - a;
    if (!(along.norm() > 0.0)) {
      keyword.fail("both points of its axis are the same",
                   "Give two points of the axis.");
    }
    system = deck.next_system++;
    CardFields fields{system, ""};
    add_vector(fields, a);
    add_vector(fields, b);
    add_vector(fields, a + along.norm() * along.unitOrthogonal());
    deck.cards.card(line.place, "CORD2C", fields);
  } else if (type.empty() || type == "R") {
    const auto axes = axes_through(0, a, a.cross(b));
    if (!axes) {
      keyword.fail(
          "its two points give no axes",
          "Give two points that do not lie on a line with the origin.");
    }
    system = write_axes(deck, *axes, line.place);
  } else {
    keyword.fail("TYPE is neither R nor C", "Use TYPE=R or TYPE=C.");
  }
  const std::string set = keyword.needed_option("NSET");
  for (const int id : deck.nodes_of(set, keyword.place)) {
    deck.system_of_node[id] = system;
  }
}

void add_node(InpDeck& deck, const InpNode& node) {
  if (node.id <= 0 || node.id > largest_inp_id) {
    fail_at(
        node.place,
        fmt::format("the node id {} is not above zero, or too large", node.id),
        "Correct the id.");
  }
  const auto [known, fresh] =
      deck.node_index.try_emplace(node.id, deck.nodes.size());
  if (!fresh) {
    fail_at(node.place,
            fmt::format("node {} is defined already in {}",
                        node.id,
                        deck.nodes[known->second].place.where),
            "Renumber one of the two, or take it out.");
  }
  deck.nodes.push_back(node);
  deck.next_grid = std::max(deck.next_grid, node.id + 1);
}

}  // namespace

void read_inp_nodes(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("NODE")) {
    const CoordinateSystem system = system_of(*keyword);
    const std::string set = keyword->option("NSET");
    if (!set.empty()) deck.node_sets[set];
    for (const DataLine& line : keyword->lines) {
      const int id = integer_in(line, 0, "node");
      add_node(
          deck,
          {id, system.place(vector_in(line, 1, "coordinate")), line.place});
      if (!set.empty()) deck.node_sets[set].push_back(id);
    }
  }
  if (deck.nodes.empty()) {
    fail_at(deck.keywords.empty() ? Place{} : deck.keywords.front().place,
            "the deck has no *NODE",
            "Give the model itself, with *NODE and *ELEMENT.");
  }
}

int write_axes(InpDeck& deck, const Eigen::Matrix3d& axes, const Place& place) {
  CardFields fields{deck.next_system, ""};
  add_vector(fields, Eigen::Vector3d::Zero());
  add_vector(fields, axes.col(2));
  add_vector(fields, axes.col(0));
  deck.cards.card(place, "CORD2R", fields);
  return deck.next_system++;
}

void write_inp_grids(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("NODALTHICKNESS")) {
    for (const DataLine& line : keyword->lines) {
      const double thickness = number_in(line, 1, "thickness");
      for (const int id : deck.nodes_of(line.text(0), line.place)) {
        deck.thickness_of_node[id] = thickness;
      }
    }
  }
  for (const Keyword* keyword : deck.of("TRANSFORM")) {
    write_transform(deck, *keyword);
  }
  for (const InpNode& node : deck.nodes) {
    if (deck.turning_node.contains(node.id)) continue;
    CardFields fields{node.id, ""};
    add_vector(fields, node.at);
    const auto system = deck.system_of_node.find(node.id);
    if (system != deck.system_of_node.end()) {
      fields.emplace_back(system->second);
    }
    deck.cards.card(node.place, "GRID", fields);
  }
}

}  // namespace tapfit::structure
