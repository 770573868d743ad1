#include "updating/structure/mesh/mesh_tying.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tapfit::structure {
namespace {

// An edge between doubles, or of a support; its middle, and the one that this
// follows (0: the ground).
struct Seam {
  std::array<int, 2> ends{};
  int middle = 0;
  int leading = 0;
};

class Seams {
 public:
  explicit Seams(SplitEdges& edges) : edges_(&edges) {}

  void tie_all() {
    const auto split = edges_->middles();
    for (const auto& [ends, middle] : split) tie(ends, middle);
    share_springs(seams_);
    std::vector<Seam> support;
    for (const HeldEdge& edge : edges_->held_edges()) {
      support.push_back({edge.ends, edge.middle, 0});
    }
    share_springs(support);
  }

 private:
  // The middle that the one between two doubles follows; 0 where the doubles
  // end nowhere, or at one body.
  int tie(const std::array<int, 2>& ends, int middle_of_doubles) {
    const auto a = edges_->doubles().find(ends[0]);
    const auto b = edges_->doubles().find(ends[1]);
    if (a == edges_->doubles().end() || b == edges_->doubles().end()) return 0;
    const int from = a->second.leader;
    const int to = b->second.leader;
    if (from == to) return 0;
    const std::array<int, 2> leaders = {std::min(from, to), std::max(from, to)};
    int leading = 0;
    if (const auto known = edges_->middles().find(leaders);
        known != edges_->middles().end()) {
      leading = known->second;
    } else if (ends_at_an_edge(leaders)) {
      leading = edges_->middle(from, to);
      tie(leaders, leading);
    }
    if (leading == 0) return 0;
    const Components common = edges_->shared(
        edges_->grid_of(middle_of_doubles), {ends[0], ends[1]}, [&](int id) {
          return edges_->doubles().at(id).components;
        });
    if (common.empty()) return 0;
    edges_->mesh().deck.rigids.push_back(
        {edges_->next_element(), leading, {{middle_of_doubles, common}}});
    seams_.push_back({ends, middle_of_doubles, leading});
    return leading;
  }

  // Whether doubles of doubles come to an edge that was split.
  [[nodiscard]] bool ends_at_an_edge(std::array<int, 2> ends) const {
    for (std::size_t steps = 0; steps <= edges_->doubles().size(); ++steps) {
      std::sort(ends.begin(), ends.end());
      if (edges_->middles().contains(ends)) return true;
      for (int& end : ends) {
        const auto next = edges_->doubles().find(end);
        if (next == edges_->doubles().end()) return false;
        end = next->second.leader;
      }
    }
    return false;
  }

  // Of a spring between a grid and its double, or between a held grid and the
  // ground, each edge at whose other end is one too has the share of its
  // length; half of that goes to its middle.
  void share_springs(const std::vector<Seam>& seams) {
    const auto side = [this](const Seam& seam) {
      return (edges_->grid_of(seam.ends[1]).position -
              edges_->grid_of(seam.ends[0]).position)
          .norm();
    };
    const std::vector<ScalarElement> whole = edges_->mesh().deck.scalars;
    for (std::size_t k = 0; k < whole.size(); ++k) {
      std::vector<std::pair<double, ScalarElement>> parts;
      double length = 0.0;
      for (const Seam& seam : seams) {
        for (const std::size_t end : {0, 1}) {
          const auto part = at_middle(whole[k], seam, seam.ends[end]);
          if (!part || !has_like(whole[k], seam, seam.ends[1 - end], whole)) {
            continue;
          }
          parts.emplace_back(side(seam), *part);
          length += side(seam);
        }
      }
      for (auto& [own, part] : parts) {
        move_share(0.5 * own / length, part, edges_->mesh().deck.scalars[k]);
      }
    }
  }

  // The spring at an edge's end as it would be at the edge's middle; nothing
  // where it does not join that end to what the edge follows.
  [[nodiscard]] std::optional<ScalarElement> at_middle(
      const ScalarElement& spring, const Seam& seam, int end) const {
    ScalarElement part = spring;
    const int other = seam.leading == 0 ? 0 : edges_->doubles().at(end).leader;
    for (int& grid : part.grids) {
      if (grid == end) {
        grid = seam.middle;
      } else if (grid == other) {
        grid = seam.leading;
      } else {
        return std::nullopt;
      }
    }
    return part.grids[0] == part.grids[1] ? std::nullopt : std::optional(part);
  }

  [[nodiscard]] bool has_like(const ScalarElement& spring,
                              const Seam& seam,
                              int end,
                              const std::vector<ScalarElement>& all) const {
    return std::ranges::any_of(all, [&](const ScalarElement& other) {
      return other.components == spring.components &&
             at_middle(other, seam, end).has_value();
    });
  }

  void move_share(double share, ScalarElement& part, ScalarElement& left) {
    const int parent = part.id;
    const ScalarElement whole = part;
    part.id = edges_->next_element();
    for (double ScalarElement::*const value : {&ScalarElement::stiffness,
                                               &ScalarElement::damping,
                                               &ScalarElement::mass}) {
      part.*value = share * whole.*value;
      left.*value -= part.*value;
    }
    edges_->mesh().children[parent].push_back(part.id);
    edges_->mesh().deck.scalars.push_back(part);
  }

  SplitEdges* edges_;
  std::vector<Seam> seams_;
};

}  // namespace

void tie_seams(SplitEdges& edges) { Seams(edges).tie_all(); }

}  // namespace tapfit::structure
