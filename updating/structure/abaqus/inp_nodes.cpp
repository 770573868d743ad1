// *NODE, *TRANSFORM and *NODAL THICKNESS; GRID cards.
#include "acquisition/foundation/coordinate_system.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

Eigen::Vector3d vector_in(const DataLine& line,
                          std::size_t first,
                          const char* meaning) {
  return {number_or(line, first, 0.0, meaning),
          number_or(line, first + 1, 0.0, meaning),
          number_or(line, first + 2, 0.0, meaning)};
}

// SYSTEM=C, S: coordinates are r, theta, z or r, theta, phi.
CoordinateSystem system_of(const Keyword& keyword) {
  CoordinateSystem system;
  const std::string kind = keyword.option("SYSTEM");
  if (kind == "C") system.kind = CoordinateKind::Cylindrical;
  if (kind == "S") {
    keyword.fail("spherical coordinates are not read",
                 "Write the nodes' places as x, y, z.");
  }
  return system;
}

// The system of a *TRANSFORM as CORD2R or CORD2C.
int write_transform(InpDeck& deck, const Keyword& keyword) {
  const DataLine& line = keyword.line(0, "two points");
  const Eigen::Vector3d a = vector_in(line, 0, "point a");
  const Eigen::Vector3d b = vector_in(line, 3, "point b");
  const std::string type = keyword.option("TYPE");
  if (type == "C") {
    const Eigen::Vector3d along = b - a;
    if (!(along.norm() > 0.0)) {
      keyword.fail("both points of its axis are the same",
                   "Give two points of the axis.");
    }
    Eigen::Vector3d beside = Eigen::Vector3d::UnitX();
    if (along.cross(beside).norm() < 0.1 * along.norm()) {
      beside = Eigen::Vector3d::UnitY();
    }
    std::vector<std::string> fields{fmt::format("{}", deck.next_system), ""};
    for (const Eigen::Vector3d& p :
         {a, b, Eigen::Vector3d(a + along.norm() * beside)}) {
      for (const double x : p) fields.push_back(real_field(x));
    }
    deck.cards.card(line.place, "CORD2C", fields);
    return deck.next_system++;
  }
  if (!type.empty() && type != "R") {
    keyword.fail("TYPE is neither R nor C", "Use TYPE=R or TYPE=C.");
  }
  const std::optional<Eigen::Matrix3d> x_first = axes_through(0, a, a.cross(b));
  if (!x_first) {
    keyword.fail("its two points give no axes",
                 "Give two points that do not lie on a line with the origin.");
  }
  return write_axes(deck, *x_first, line.place);
}

void read_thicknesses(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("NODALTHICKNESS")) {
    for (const DataLine& line : keyword->lines) {
      const double thickness = number_in(line, 1, "thickness");
      for (const int id : deck.nodes_of(line.text(0), line.place)) {
        deck.thickness_of_node[id] = thickness;
      }
    }
  }
}

}  // namespace

void read_inp_nodes(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("NODE")) {
    const CoordinateSystem system = system_of(*keyword);
    const std::string set = keyword->option("NSET");
    if (!set.empty()) deck.node_sets[set];
    for (const DataLine& line : keyword->lines) {
      const int id = integer_in(line, 0, "node");
      if (id <= 0 || id > largest_inp_id) {
        fail_at(
            line.place,
            fmt::format("the node id {} is not above zero, or too large", id),
            "Correct the id.");
      }
      const auto [known, fresh] =
          deck.node_index.try_emplace(id, deck.nodes.size());
      if (!fresh) {
        fail_at(line.place,
                fmt::format("node {} is defined already in {}",
                            id,
                            deck.nodes[known->second].place.where),
                "Renumber one of the two, or take it out.");
      }
      deck.nodes.push_back(
          {id, system.place(vector_in(line, 1, "coordinate")), line.place});
      deck.next_grid = std::max(deck.next_grid, id + 1);
      if (!set.empty()) deck.node_sets[set].push_back(id);
    }
  }
  if (deck.nodes.empty()) {
    const Place place =
        deck.keywords.empty() ? Place{} : deck.keywords.front().place;
    fail_at(place,
            "the deck has no *NODE",
            "Give the model itself, with *NODE and *ELEMENT.");
  }
}

int write_axes(InpDeck& deck, const Eigen::Matrix3d& axes, const Place& place) {
  std::vector<std::string> fields{fmt::format("{}", deck.next_system), ""};
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(Eigen::Vector3d::Zero()),
                                   Eigen::Vector3d(axes.col(2)),
                                   Eigen::Vector3d(axes.col(0))}) {
    for (const double x : p) fields.push_back(real_field(x));
  }
  deck.cards.card(place, "CORD2R", fields);
  return deck.next_system++;
}

void write_inp_grids(InpDeck& deck) {
  read_thicknesses(deck);
  for (const Keyword* keyword : deck.of("TRANSFORM")) {
    const int system = write_transform(deck, *keyword);
    const std::string set = keyword->needed_option("NSET");
    for (const int id : deck.nodes_of(set, keyword->place)) {
      deck.system_of_node[id] = system;
    }
  }
  for (const InpNode& node : deck.nodes) {
    if (deck.turning_node.contains(node.id)) continue;
    const auto system = deck.system_of_node.find(node.id);
    deck.cards.card(node.place,
                    "GRID",
                    {fmt::format("{}", node.id),
                     "",
                     real_field(node.at.x()),
                     real_field(node.at.y()),
                     real_field(node.at.z()),
                     system == deck.system_of_node.end()
                         ? ""
                         : fmt::format("{}", system->second)});
  }
}

}  // namespace tapfit::structure
