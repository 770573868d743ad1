#include "updating/places/support_line.hpp"

#include "updating/places/support_axes.hpp"
#include "updating/places/support_face.hpp"
#include "updating/places/support_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::ConstraintAxes;
using structure::Deck;

bool is_in(const std::string& components, int component) {
  return components.find(static_cast<char>('0' + component)) !=
         std::string::npos;
}

bool holds(const ConstraintAxes& axes, int node, int component) {
  return is_in(axes.held_in_basic(node), component);
}

// Axis (0..2) along which the points lie, or -1.
int line_axis(const Deck& deck, const std::vector<int>& nodes) {
  Eigen::Vector3d low = deck.grid(nodes[0]).position;
  Eigen::Vector3d high = low;
  for (const int node : nodes) {
    const Eigen::Vector3d& x = deck.grid(node).position;
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Eigen::Vector3d span = high - low;
  Eigen::Index axis = 0;
  const double longest = span.maxCoeff(&axis);
  const double rest = span.sum() - longest;
  // Straight to 1 % of the length: the tolerance of a drawn clamp edge.
  return longest > 0.0 && rest <= 0.01 * longest ? static_cast<int>(axis) : -1;
}

// Length that each node carries: half the gap on either side. Between two
// separate edges on one line there is a gap, but nothing held. Where grids
// stand alone, each stands for the gaps beside it.
std::vector<double> tributary_lengths(const std::vector<double>& x,
                                      const std::vector<bool>& connected) {
  const std::size_t n = x.size();
  const auto lengths_over = [&](bool all) {
    std::vector<double> lengths(n, 0.0);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      if (!all && !connected[k]) continue;
      const double half = 0.5 * (x[k + 1] - x[k]);
      lengths[k] += half;
      lengths[k + 1] += half;
    }
    return lengths;
  };
  std::vector<double> lengths = lengths_over(false);
  const bool alone = std::any_of(
      lengths.begin(), lengths.end(), [](double l) { return l == 0.0; });
  return alone ? lengths_over(true) : lengths;
}

// Where a frame stands on several feet, each is a support of its own, as are
// clamped edges that lie on no line together. Bolts along the edge of a plate
// are one.
std::vector<std::vector<int>> separate_supports(const Deck& deck,
                                                const std::vector<int>& nodes) {
  std::set<int> on_shells;
  for (const structure::Shell& shell : deck.shells) {
    on_shells.insert(shell.grids.begin(), shell.grids.end());
  }
  const std::set<int> wanted(nodes.begin(), nodes.end());
  std::vector<std::vector<int>> supports;
  std::vector<std::vector<int>> edges;
  std::vector<int> all;
  for (std::vector<int> group : support_groups(deck)) {
    std::erase_if(group, [&](int node) { return !wanted.contains(node); });
    if (group.empty()) continue;
    if (group.size() == 1 && !on_shells.contains(group.front())) {
      supports.push_back(group);
      continue;
    }
    all.insert(all.end(), group.begin(), group.end());
    edges.push_back(std::move(group));
  }
  if (edges.size() > 1 && line_axis(deck, all) >= 0) edges = {all};
  supports.insert(supports.end(), edges.begin(), edges.end());
  return supports;
}

// The held edges that grids lie on, half of each at either end.
struct HalfEdge {
  int node = 0;
  double length = 0.0;  // [m]
  int axis = -1;        // 0..2 that it runs along, or -1
};

std::vector<HalfEdge> half_edges(const Deck& deck,
                                 const std::vector<int>& nodes) {
  const std::map<int, std::set<int>> near = joined_grids(deck);
  const std::set<int> held(nodes.begin(), nodes.end());
  std::vector<HalfEdge> halves;
  for (const int node : held) {
    const auto it = near.find(node);
    if (it == near.end()) return {};
    bool joined = false;
    for (const int next : it->second) {
      if (!held.contains(next)) continue;
      joined = true;
      const double length =
          (deck.grid(next).position - deck.grid(node).position).norm();
      halves.push_back({node, 0.5 * length, line_axis(deck, {node, next})});
    }
    if (!joined) return {};
  }
  return halves;
}

// Along held edges that are bent, or closed: each turns about itself, where all
// run along axes.
SupportLine bent_line(const std::vector<HalfEdge>& halves,
                      const ConstraintAxes& held,
                      bool rotation) {
  SupportLine line;
  const bool along_axes = std::ranges::all_of(
      halves, [](const HalfEdge& half) { return half.axis >= 0; });
  std::map<std::pair<int, int>, double> lengths;  // of a grid and component
  for (const HalfEdge& half : halves) {
    line.length += half.length;
    for (int axis = 0; axis < 3; ++axis) {
      if (rotation && along_axes && axis != half.axis) continue;
      lengths[{half.node, (rotation ? 4 : 1) + axis}] += half.length;
    }
  }
  for (const auto& [dof, length] : lengths) {
    const auto& [node, component] = dof;
    if (holds(held, node, component)) {
      line.dofs.push_back({node, component, length});
    }
  }
  return line;
}

// Along one line.
SupportLine straight_line(const Deck& deck,
                          const ConstraintAxes& held,
                          std::vector<int> order,
                          int axis,
                          bool rotation) {
  SupportLine line;
  line.straight = true;
  const auto along = [&deck, axis](int node) {
    return deck.grid(node).position(axis);
  };
  std::sort(order.begin(), order.end(), [&along](int a, int b) {
    return along(a) < along(b);
  });
  std::vector<double> x(order.size());
  std::transform(order.begin(), order.end(), x.begin(), along);
  const std::map<int, std::set<int>> near = joined_grids(deck);
  std::vector<bool> connected;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto it = near.find(order[k]);
    connected.push_back(it != near.end() && it->second.contains(order[k + 1]));
  }
  const std::vector<double> lengths = tributary_lengths(x, connected);
  line.length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const std::vector<int> components =
      rotation ? std::vector<int>{4 + axis} : std::vector<int>{1, 2, 3};
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double at = (x[k] - x.front()) / (x.back() - x.front());
    for (const int c : components) {
      if (holds(held, order[k], c)) {
        line.dofs.push_back({order[k], c, lengths[k], at});
      }
    }
  }
  return line;
}

// Of grids on one line, along edges, or apart.
SupportLine single_line(const Deck& deck,
                        const std::vector<int>& nodes,
                        bool rotation) {
  const ConstraintAxes held = support_axes(deck).axes;
  if (const int axis = nodes.size() > 1 ? line_axis(deck, nodes) : -1;
      axis >= 0) {
    return straight_line(deck, held, nodes, axis, rotation);
  }
  if (const auto halves = half_edges(deck, nodes); !halves.empty()) {
    return bent_line(halves, held, rotation);
  }
  SupportLine line;
  line.length = 1.0;
  for (const int node : nodes) {
    for (int c = rotation ? 4 : 1; c <= (rotation ? 6 : 3); ++c) {
      if (!holds(held, node, c)) continue;
      line.dofs.push_back({node, c, 1.0 / static_cast<double>(nodes.size())});
    }
  }
  return line;
}

}  // namespace

SupportLine support_line(const Deck& deck,
                         const std::vector<int>& nodes,
                         bool rotation) {
  SupportLine whole;
  const std::vector<std::vector<int>> supports = separate_supports(deck, nodes);
  for (const std::vector<int>& support : supports) {
    const SupportLine line = single_line(deck, support, rotation);
    whole.length += line.length;
    whole.straight = line.straight && supports.size() == 1;
    for (SupportDof dof : line.dofs) {
      if (!whole.straight) dof.at = 0.0;
      whole.dofs.push_back(dof);
    }
  }
  return whole;
}

namespace {

// The share of a line that goes with the stiffness at one of its ends.
SupportPart towards(const SupportLine& line, SupportMotion motion, bool last) {
  SupportPart part{motion, 0, {}};
  part.line.straight = line.straight;
  part.end = last ? line.dofs.back().node : line.dofs.front().node;
  for (SupportDof dof : line.dofs) {
    dof.length *= last ? dof.at : 1.0 - dof.at;
    if (dof.length <= 0.0) continue;
    part.line.length += dof.length;
    part.line.dofs.push_back(dof);
  }
  return part;
}

struct Freed {
  std::string variant;
  std::vector<int> components;
};

const std::vector<Freed>& all_freed() {
  static const std::vector<Freed> all = {{"free", {1, 2, 3, 4, 5, 6}},
                                         {"free-rotations", {4, 5, 6}},
                                         {"free-X", {1}},
                                         {"free-Y", {2}},
                                         {"free-Z", {3}}};
  return all;
}

// All that is held in some components, as one part; none where nothing is.
std::vector<SupportPart> freed_part(const Deck& deck,
                                    const std::vector<int>& nodes,
                                    const std::vector<int>& components) {
  const ConstraintAxes held = support_axes(deck).axes;
  // All three of a kind are all that is held so, along whatever axes.
  const bool any_axes = components.size() > 1;
  SupportPart part{components.front() > 3 ? SupportMotion::Rotation
                                          : SupportMotion::Translation,
                   0,
                   {}};
  part.line.length = 1.0;
  const double share = 1.0 / static_cast<double>(nodes.size());
  for (const int node : nodes) {
    const bool turned = held.turned.contains(node);
    const auto own = held.held.find(node);
    if (own == held.held.end() || (turned && !any_axes)) continue;
    for (const int c : components) {
      if (own->second.find(static_cast<char>('0' + c)) == std::string::npos) {
        continue;
      }
      part.line.dofs.push_back({node, c, share, 0.0, turned});
    }
  }
  if (part.line.dofs.empty()) return {};
  return {part};
}

// Of sections apart where it is least.
double turn_of(const std::vector<SupportDof>& face, const SupportLine& turns) {
  std::map<int, double> sums;
  for (const SupportDof& turn : turns.dofs) sums[turn.component] = 0.0;
  for (const SupportDof& dof : face) {
    const auto sum = sums.find(dof.component);
    if (dof.with == 0 && sum != sums.end()) sum->second += dof.length;
  }
  std::erase_if(sums, [](const auto& sum) { return sum.second <= 0.0; });
  const auto least =
      std::ranges::min_element(sums, {}, &std::pair<const int, double>::second);
  return least == sums.end() ? 0.0 : least->second;
}

// What is held of a face; none where a grid of it turns freely, or is held
// along turned axes.
std::vector<SupportPart> face_part(const Deck& deck,
                                   const std::vector<int>& nodes) {
  // What two halves of an edge cancel to [m^2].
  constexpr double rounding = 1e-15;
  const auto [held, everywhere] = support_axes(deck);
  SupportPart part{SupportMotion::Face, 0, support_line(deck, nodes, true)};
  std::vector<SupportDof> face;
  for (const auto& [node, S] : support_face(deck, nodes)) {
    for (int a = 1; a <= 6; ++a) {
      if (S(a - 1, a - 1) <= 0.0 || is_in(everywhere, a)) continue;
      if (!holds(held, node, a)) return {};
      face.push_back({node, a, S(a - 1, a - 1)});
      for (int b = a + 1; b <= 6; ++b) {
        const double coupled = S(a - 1, b - 1);
        const bool none =
            std::abs(coupled) <= rounding * S.diagonal().maxCoeff();
        if (none || is_in(everywhere, b)) continue;
        if (!deck.grid(node).axes.isIdentity()) return {};
        face.push_back({node, a, coupled, 0.0, false, b});
      }
    }
  }
  part.turn = edges_turn(deck, nodes);
  if (part.turn <= 0.0) part.turn = turn_of(face, part.line);
  part.line.dofs = std::move(face);
  if (part.turn <= 0.0) return {};
  return {part};
}

}  // namespace

std::vector<std::string> freed_variants() {
  std::vector<std::string> names;
  for (const Freed& freed : all_freed()) names.push_back(freed.variant);
  return names;
}

std::string freed_components(const std::string& variant) {
  std::string digits;
  const auto freed = std::ranges::find(all_freed(), variant, &Freed::variant);
  if (freed == all_freed().end()) return digits;
  for (const int c : freed->components) digits += static_cast<char>('0' + c);
  return digits;
}

std::vector<SupportPart> support_parts(const Deck& deck,
                                       const std::vector<int>& nodes,
                                       const std::string& variant) {
  const auto freed = std::ranges::find(all_freed(), variant, &Freed::variant);
  if (freed != all_freed().end()) {
    return freed_part(deck, nodes, freed->components);
  }
  if (variant == "face") return face_part(deck, nodes);
  std::vector<SupportPart> parts;
  for (const SupportMotion motion :
       {SupportMotion::Rotation, SupportMotion::Translation}) {
    const bool rotation = motion == SupportMotion::Rotation;
    const std::string kind = rotation ? "rotation" : "translation";
    if (variant != "both" && !variant.starts_with(kind)) continue;
    const SupportLine line = support_line(deck, nodes, rotation);
    if (line.dofs.empty()) return {};
    if (!variant.ends_with("-varying")) {
      parts.push_back({motion, 0, line});
      continue;
    }
    // One grid alone says nothing of how it goes on.
    if (line.dofs.front().at == line.dofs.back().at) return {};
    for (const bool last : {false, true}) {
      parts.push_back(towards(line, motion, last));
    }
  }
  return parts;
}

}  // namespace tapfit::updating
