// *TIE: nodes of the slave surface follow the face of the master surface that
// they lie on, by MPC,
//
//   u_slave = sum_i N_i u_i,
//
// or the one node of it that is at their place.
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/face_shapes.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tapfit::structure {
namespace {

struct MasterFace {
  std::vector<int> ids;
  std::vector<Eigen::Vector3d> at;
  Eigen::Vector3d low, high;
  double size = 0.0;  // the diagonal of its box
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
    face.size = (face.high - face.low).norm();
    faces.push_back(std::move(face));
  }
  return faces;
}

const InpSurface& surface_of(const InpDeck& deck,
                             const std::string& name,
                             const Place& place) {
  const auto found = deck.surfaces.find(name);
  if (found == deck.surfaces.end()) {
    constexpr std::size_t most = 40;
    fail_at(place,
            fmt::format("the surface {} is not defined", name.substr(0, most)),
            "Define it by *SURFACE, NAME=..., or correct the name.");
  }
  return found->second;
}

struct Share {
  int node = 0;
  double factor = 0.0;
};

void write_follower(InpDeck& deck,
                    const Place& place,
                    int slave,
                    const std::vector<Share>& on,
                    int dofs) {
  for (int dof = 1; dof <= dofs; ++dof) {
    const std::string component = fmt::format("{}", dof);
    std::vector<std::string> fields{
        "1", fmt::format("{}", slave), component, "1."};
    std::size_t terms = 1;
    for (const Share& share : on) {
      if (terms % 2 == 0) fields.resize(fields.size() + 2);
      fields.push_back(fmt::format("{}", share.node));
      fields.push_back(component);
      fields.push_back(real_field(-share.factor));
      ++terms;
    }
    deck.cards.card(place, "MPC", fields);
  }
}

// The nearest face within the tolerance.
std::vector<Share> shares_on(const std::vector<MasterFace>& faces,
                             const Eigen::Vector3d& p,
                             double tolerance) {
  constexpr double share_of_size = 0.05;
  constexpr double nothing = 1e-8;
  std::vector<Share> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const MasterFace& face : faces) {
    const double within =
        tolerance > 0.0 ? tolerance : share_of_size * face.size;
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
                              const Eigen::Vector3d& p,
                              double tolerance) {
  std::vector<Share> best;
  double nearest = std::max(tolerance, 1e-6 * (1.0 + p.norm()));
  for (const int id : master.nodes) {
    const double distance = (deck.node(id, {}).at - p).norm();
    if (distance > nearest) continue;
    nearest = distance;
    best = {{id, 1.0}};
  }
  return best;
}

// Nodes that turn.
std::set<int> nodes_of_shells(const InpDeck& deck) {
  std::set<int> nodes;
  for (const InpElement& e : deck.elements) {
    if (e.type == nullptr || (e.type->family != InpFamily::Shell &&
                              e.type->family != InpFamily::Beam)) {
      continue;
    }
    nodes.insert(e.nodes.begin(), e.nodes.end());
  }
  return nodes;
}

void write_tie(InpDeck& deck, const Keyword& keyword, const DataLine& line) {
  const InpSurface& slave = surface_of(deck, upper(line.text(0)), line.place);
  const InpSurface& master = surface_of(deck, upper(line.text(1)), line.place);
  const DataLine option{
      {keyword.option("POSITIONTOLERANCE")}, keyword.place, false};
  const double tolerance = number_or(option, 0, 0.0, "POSITION TOLERANCE");
  const std::vector<MasterFace> faces =
      faces_of_master(deck, master, line.place);
  const std::set<int> turning =
      master.of_shells ? nodes_of_shells(deck) : std::set<int>{};
  std::size_t loose = 0;
  for (const int id : slave.nodes) {
    if (std::ranges::binary_search(master.nodes, id)) continue;
    const Eigen::Vector3d p = deck.node(id, line.place).at;
    const std::vector<Share> on = faces.empty()
                                      ? same_place(deck, master, p, tolerance)
                                      : shares_on(faces, p, tolerance);
    if (on.empty()) {
      ++loose;
      continue;
    }
    write_follower(deck, line.place, id, on, turning.contains(id) ? 6 : 3);
  }
  if (loose > 0) {
    say(deck,
        fmt::format("{}: {} of {} nodes of the slave surface lie on no face of "
                    "the master surface and are not tied",
                    line.place.where,
                    loose,
                    slave.nodes.size()));
  }
}

}  // namespace

void write_inp_ties(InpDeck& deck) {
  LeftOutCounts others;
  for (const Keyword* keyword : deck.of("TIE")) {
    if (keyword->has("CYCLICSYMMETRY") || keyword->has("MULTISTAGE")) {
      count_left_out(others,
                     "TIE",
                     keyword->place,
                     "a sector is not closed to the whole; write the whole "
                     "model");
      continue;
    }
    for (const DataLine& line : keyword->lines) write_tie(deck, *keyword, line);
  }
  add_left_out(deck, others);
}

}  // namespace tapfit::structure
