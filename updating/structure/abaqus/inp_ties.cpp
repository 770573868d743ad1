// *TIE: nodes of the slave surface follow the face of the master surface that
// they lie on, by MPC,
//
//   u_slave = sum_i N_i u_i,
//
// or the one node of it that is at their place.
#include "updating/structure/abaqus/face_shapes.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace tapfit::structure {
namespace {

struct MasterFace {
  std::vector<int> ids;
  std::vector<Eigen::Vector3d> at;
  Eigen::Vector3d low, high;
};

std::vector<MasterFace> faces_of_master(const InpDeck& deck,
                                        const InpSurface& surface,
                                        const Place& place) {
  std::vector<MasterFace> faces;
  for (const std::vector<int>& ids : surface.faces) {
    MasterFace face;
    face.ids = ids;
    for (const int id : ids) face.at.push_back(deck.node(id, place).at);
    face.low = face.high = face.at.front();
    for (const Eigen::Vector3d& p : face.at) {
      face.low = face.low.cwiseMin(p);
      face.high = face.high.cwiseMax(p);
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

struct Share {
  int node = 0;
  double factor = 0.0;
};

// The nearest face within the tolerance; without one within a share of the
// face's diagonal.
std::vector<Share> shares_on(const std::vector<MasterFace>& faces,
                             const Eigen::Vector3d& p,
                             double tolerance) {
  constexpr double share_of_size = 0.05;
  constexpr double nothing = 1e-8;
  std::vector<Share> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const MasterFace& face : faces) {
    const double within = tolerance > 0.0
                              ? tolerance
                              : share_of_size * (face.high - face.low).norm();
    const bool far = ((face.low - p).array() > within).any() ||
                     ((p - face.high).array() > within).any();
    if (far) continue;
    const std::optional<OnFace> on = place_on_face(face.at, p);
    if (!on || on->distance > within || on->distance >= nearest) continue;
    nearest = on->distance;
    best.clear();
    for (std::size_t k = 0; k < face.ids.size(); ++k) {
      const double N = on->shares(static_cast<Eigen::Index>(k));
      if (std::abs(N) > nothing) best.push_back({face.ids[k], N});
    }
  }
  return best;
}

// Of master surfaces of nodes: the one at the same place.
std::vector<Share> same_place(const InpDeck& deck,
                              const InpSurface& master,
                              const InpNode& slave,
                              double tolerance) {
  std::vector<Share> best;
  double nearest = std::max(tolerance, 1e-6 * (1.0 + slave.at.norm()));
  for (const int id : master.nodes) {
    const double distance = (deck.node(id, slave.place).at - slave.at).norm();
    if (distance > nearest) continue;
    nearest = distance;
    best = {{id, 1.0}};
  }
  return best;
}

// Nodes of shells and beams.
std::set<int> nodes_that_turn(const InpDeck& deck) {
  std::set<int> nodes;
  for (const InpElement& e : deck.elements) {
    if (e.is(InpFamily::Shell) || e.is(InpFamily::Beam)) {
      nodes.insert(e.nodes.begin(), e.nodes.end());
    }
  }
  return nodes;
}

void write_follower(InpDeck& deck,
                    const Place& place,
                    int slave,
                    const std::vector<Share>& on,
                    int dofs) {
  for (int dof = 1; dof <= dofs; ++dof) {
    std::vector<RelationTerm> terms{{slave, dof, 1.0}};
    for (const Share& share : on) {
      terms.push_back({share.node, dof, -share.factor});
    }
    write_relation(deck, place, terms);
  }
}

void write_tie(InpDeck& deck, const Keyword& keyword, const DataLine& line) {
  const InpSurface& slave =
      named_in(deck.surfaces, line.name(0), "surface", line.place);
  const InpSurface& master =
      named_in(deck.surfaces, line.name(1), "surface", line.place);
  const double tolerance = keyword.option_number("POSITIONTOLERANCE");
  const std::vector<MasterFace> faces =
      faces_of_master(deck, master, line.place);
  const std::set<int> turning = nodes_that_turn(deck);
  std::size_t loose = 0;
  for (const int id : slave.nodes) {
    if (std::ranges::binary_search(master.nodes, id)) continue;
    const InpNode& node = deck.node(id, line.place);
    const std::vector<Share> on =
        faces.empty() ? same_place(deck, master, node, tolerance)
                      : shares_on(faces, node.at, tolerance);
    loose += on.empty() ? 1 : 0;
    const bool turns =
        turning.contains(id) && std::ranges::all_of(on, [&](const Share& s) {
          return turning.contains(s.node);
        });
    if (!on.empty()) write_follower(deck, line.place, id, on, turns ? 6 : 3);
  }
  if (loose > 0) {
    deck.say(fmt::format(
        "{}: {} of {} nodes of the slave surface lie on no face of the master "
        "surface and are not tied",
        line.place.where,
        loose,
        slave.nodes.size()));
  }
}

}  // namespace

void write_inp_ties(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("TIE")) {
    if (keyword->has("CYCLICSYMMETRY") || keyword->has("MULTISTAGE")) {
      deck.leave_out("TIE",
                     keyword->place,
                     "a sector is not closed to the whole; write the whole "
                     "model");
      continue;
    }
    for (const DataLine& line : keyword->lines) write_tie(deck, *keyword, line);
  }
}

}  // namespace tapfit::structure
