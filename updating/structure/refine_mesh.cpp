#include "updating/structure/refine_mesh.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace tapfit::structure {
namespace {

using Components = std::string;  // digits of 1..6

Components shared_components(const Components& a, const Components& b) {
  Components both;
  for (const char digit : a) {
    if (b.find(digit) != std::string::npos) both += digit;
  }
  return both;
}

// All three translations, all three rotations: these need no axes.
Components whole_triples(const Components& components) {
  Components whole;
  for (const char* const triple : {"123", "456"}) {
    if (shared_components(triple, components) == triple) whole += triple;
  }
  return whole;
}

// The rotation nearest to the mean of several.
Eigen::Matrix3d mean_axes(const std::vector<Eigen::Matrix3d>& axes) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Matrix3d& one : axes) sum += one;
  if (sum == static_cast<double>(axes.size()) * axes.front()) {
    return axes.front();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d Q = svd.matrixU() * svd.matrixV().transpose();
  return Q.determinant() > 0.0 ? Q : axes.front();
}

// Axes of which the digits mean nearly the same: within 60 degrees.
bool alike(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a.transpose() * b).trace() > 2.0;
}

// Makes new grids and elements, one grid per edge whoever asks first.
class Refiner {
 public:
  explicit Refiner(const Deck& deck) {
    result_.deck = deck;
    Deck& out = result_.deck;
    out.shells.clear();
    out.bars.clear();
    out.cards.clear();
    Eigen::AlignedBox3d box;
    for (const Grid& grid : deck.grids) {
      next_grid_ = std::max(next_grid_, grid.id + 1);
      box.extend(grid.position);
    }
    extent_ = box.isEmpty() ? 0.0 : box.diagonal().norm();
    for (const Constraint& held : deck.constraints) {
      held_[held.grid] += held.components;
    }
    for (std::size_t k = 0; k < deck.rigids.size(); ++k) see_rigid(k);
    for (const Shell& e : deck.shells) see_element(e.id);
    for (const Bar& e : deck.bars) see_element(e.id);
    for (const Rod& e : deck.rods) keep(e.id);
    for (const PointMass& e : deck.masses) keep(e.id);
    for (const ScalarElement& e : deck.scalars) keep(e.id);
    for (const Bush& e : deck.bushes) keep(e.id);
    for (const Shell& e : deck.shells) split(e);
    for (const Bar& e : deck.bars) split(e);
    tie_seams();
  }

  [[nodiscard]] RefinedDeck take() { return std::move(result_); }

 private:
  // What a double at the same place follows, and in which components.
  struct Double {
    int leader = 0;
    Components components;
  };
  // An edge between doubles, or of a support; its middle, and the one that this
  // follows (0: the ground).
  struct Seam {
    std::array<int, 2> ends{};
    int middle = 0;
    int leading = 0;
  };

  void see_element(int id) { next_element_ = std::max(next_element_, id + 1); }

  void keep(int id) {
    see_element(id);
    result_.children[id] = {id};
  }

  void see_rigid(std::size_t k) {
    const RigidElement& e = result_.deck.rigids[k];
    see_element(e.id);
    rigid_[e.independent][k] = "123456";
    for (const Dependent& d : e.dependents) {
      rigid_[d.grid][k] = d.components;
      const Eigen::Vector3d apart =
          grid_of(d.grid).position - grid_of(e.independent).position;
      // Coordinates of another system are rounded.
      if (apart.norm() <= 1e-6 * extent_) {
        doubled_[d.grid] = {e.independent, d.components};
      }
    }
  }

  [[nodiscard]] const Grid& grid_of(int id) const {
    return result_.deck.grids[result_.deck.grid_index(id)];
  }

  int add_grid(const std::vector<int>& between) {
    Grid grid;
    grid.id = next_grid_++;
    grid.position.setZero();
    std::vector<Eigen::Matrix3d> axes;
    for (const int id : between) {
      const Grid& end = grid_of(id);
      grid.position += end.position;
      axes.push_back(end.axes);
    }
    grid.position /= static_cast<double>(between.size());
    grid.axes = mean_axes(axes);
    result_.deck.grids.push_back(grid);
    result_.between[grid.id] = between;
    follow(grid, between);
    return grid.id;
  }

  // What all of several grids have, said along a new grid's axes.
  [[nodiscard]] Components shared(
      const Grid& grid,
      const std::vector<int>& between,
      const std::function<Components(int)>& of) const {
    Components common = of(between.front());
    for (const int id : between) {
      common = shared_components(common, of(id));
      if (!common.empty() && !alike(grid.axes, grid_of(id).axes)) {
        common = whole_triples(common);
      }
    }
    return common;
  }

  // Between grids of one rigid body everything is rigid.
  void follow(const Grid& grid, const std::vector<int>& between) {
    const auto bodies = rigid_.find(between.front());
    if (bodies == rigid_.end()) return;
    for (const auto& [k, all] : bodies->second) {
      const std::size_t body = k;
      const Components common = shared(grid, between, [&](int id) {
        const auto ends = rigid_.find(id);
        if (ends == rigid_.end()) return Components();
        const auto end = ends->second.find(body);
        return end == ends->second.end() ? Components() : end->second;
      });
      if (common.empty()) continue;
      result_.deck.rigids[body].dependents.push_back({grid.id, common});
    }
  }

  int middle(int a, int b) {
    const auto [place, is_new] =
        middles_.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (!is_new) return place->second;
    const int id = add_grid({a, b});
    place->second = id;
    const Components both =
        shared(result_.deck.grids.back(), {a, b}, [&](int end) {
          const auto held = held_.find(end);
          return held == held_.end() ? Components() : held->second;
        });
    if (both.empty()) return id;
    result_.deck.constraints.push_back({id, both});
    support_.push_back({{a, b}, id, 0});
    return id;
  }

  template <typename Element>
  void add_child(const Element& parent,
                 Element child,
                 std::vector<Element>& elements) {
    std::vector<int>& ids = result_.children[parent.id];
    if (!ids.empty()) child.id = next_element_++;
    ids.push_back(child.id);
    elements.push_back(child);
  }

  void split(const Shell& shell) {
    const std::size_t n = shell.grids.size();
    std::vector<int> mids;
    for (std::size_t i = 0; i < n; ++i) {
      mids.push_back(middle(shell.grids[i], shell.grids[(i + 1) % n]));
    }
    const int centre = n == 4 ? add_grid(shell.grids) : 0;
    for (std::size_t i = 0; i < n; ++i) {
      Shell child = shell;
      const int before = mids[(i + n - 1) % n];
      if (n == 4) {
        child.grids = {shell.grids[i], mids[i], centre, before};
      } else {
        child.grids = {shell.grids[i], mids[i], before};
      }
      child.theta_deg = child_angle(shell, child);
      add_child(shell, child, result_.deck.shells);
    }
    if (n == 4) return;
    Shell inner = shell;
    inner.grids = {mids[0], mids[1], mids[2]};
    inner.theta_deg = child_angle(shell, inner);
    add_child(shell, inner, result_.deck.shells);
  }

  // Elements beside a seam have grids of their own, doubles of the others' at
  // the same places: what ties and springs these ties and springs the middles
  // between them, or the halves would gape there.
  void tie_seams() {
    const auto edges = middles_;
    for (const auto& [ends, middle] : edges) tie(ends, middle);
    share_springs(seams_);
    share_springs(support_);
  }

  // The middle that the one between two doubles follows; 0 where the doubles
  // end nowhere, or at one body.
  int tie(const std::array<int, 2>& ends, int middle_of_doubles) {
    const auto a = doubled_.find(ends[0]);
    const auto b = doubled_.find(ends[1]);
    if (a == doubled_.end() || b == doubled_.end()) return 0;
    const int from = a->second.leader;
    const int to = b->second.leader;
    if (from == to) return 0;
    const std::array<int, 2> leaders = {std::min(from, to), std::max(from, to)};
    int leading = 0;
    if (const auto known = middles_.find(leaders); known != middles_.end()) {
      leading = known->second;
    } else if (ends_at_an_edge(leaders)) {
      leading = middle(from, to);
      tie(leaders, leading);
    }
    if (leading == 0) return 0;
    const Components common =
        shared(grid_of(middle_of_doubles), {ends[0], ends[1]}, [&](int id) {
          return doubled_.at(id).components;
        });
    if (common.empty()) return 0;
    result_.deck.rigids.push_back(
        {next_element_++, leading, {{middle_of_doubles, common}}});
    seams_.push_back({ends, middle_of_doubles, leading});
    return leading;
  }

  // Whether doubles of doubles come to an edge that was split.
  [[nodiscard]] bool ends_at_an_edge(std::array<int, 2> ends) const {
    for (std::size_t steps = 0; steps <= doubled_.size(); ++steps) {
      std::sort(ends.begin(), ends.end());
      if (middles_.contains(ends)) return true;
      for (int& end : ends) {
        const auto next = doubled_.find(end);
        if (next == doubled_.end()) return false;
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
      return (grid_of(seam.ends[1]).position - grid_of(seam.ends[0]).position)
          .norm();
    };
    const std::vector<ScalarElement> whole = result_.deck.scalars;
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
        move_share(0.5 * own / length, part, result_.deck.scalars[k]);
      }
    }
  }

  // The spring at an edge's end as it would be at the edge's middle; nothing
  // where it does not join that end to what the edge follows.
  [[nodiscard]] std::optional<ScalarElement> at_middle(
      const ScalarElement& spring, const Seam& seam, int end) const {
    ScalarElement part = spring;
    const int other = seam.leading == 0 ? 0 : doubled_.at(end).leader;
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
    part.id = next_element_++;
    for (double ScalarElement::*const value : {&ScalarElement::stiffness,
                                               &ScalarElement::damping,
                                               &ScalarElement::mass}) {
      part.*value = share * whole.*value;
      left.*value -= part.*value;
    }
    result_.children[parent].push_back(part.id);
    result_.deck.scalars.push_back(part);
  }

  // The material axis stays where it is while side 1-2 of the child turns.
  double child_angle(const Shell& parent, const Shell& child) const {
    const auto at = [&](int id) { return grid_of(id).position; };
    const Eigen::Vector3d side = at(parent.grids[1]) - at(parent.grids[0]);
    const Eigen::Vector3d normal =
        side.cross(at(parent.grids.back()) - at(parent.grids[0]))
            .stableNormalized();
    const Eigen::Vector3d turned = at(child.grids[1]) - at(child.grids[0]);
    const double angle =
        std::atan2(normal.dot(side.cross(turned)), side.dot(turned));
    return parent.theta_deg - angle * 180.0 / std::numbers::pi;
  }

  void split(const Bar& bar) {
    const int mid = middle(bar.grids[0], bar.grids[1]);
    const Eigen::Vector3d offset = 0.5 * (bar.offsets[0] + bar.offsets[1]);
    Bar first = bar;
    first.grids[1] = mid;
    first.offsets[1] = offset;
    first.released[1].clear();
    Bar second = bar;
    second.grids[0] = mid;
    second.offsets[0] = offset;
    second.released[0].clear();
    add_child(bar, first, result_.deck.bars);
    add_child(bar, second, result_.deck.bars);
  }

  RefinedDeck result_;
  double extent_ = 0.0;  // diagonal of the box around all grids
  int next_grid_ = 1;
  int next_element_ = 1;
  std::map<std::array<int, 2>, int> middles_;
  std::unordered_map<int, Components> held_;
  // Per grid: the rigid elements that it belongs to, and in which components.
  std::unordered_map<int, std::map<std::size_t, Components>> rigid_;
  std::unordered_map<int, Double> doubled_;
  std::vector<Seam> seams_;
  std::vector<Seam> support_;
};

}  // namespace

RefinedDeck refine_mesh(const Deck& deck) { return Refiner(deck).take(); }

}  // namespace tapfit::structure
