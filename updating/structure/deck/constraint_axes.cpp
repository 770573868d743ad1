#include "updating/structure/deck/constraint_axes.hpp"

#include <cmath>

namespace tapfit::structure {
namespace {

const Eigen::Matrix3d& axes_of(const Deck& deck, int grid) {
  return deck.grid(grid).axes;
}

using Held = std::map<int, std::string>;  // grid -> components

// @return whether that is new
bool hold(int grid, const std::string& components, Held& held) {
  std::string& known = held[grid];
  const std::size_t before = known.size();
  for (const char digit : components) {
    if (known.find(digit) == std::string::npos) known += digit;
  }
  return known.size() > before;
}

bool holds_wholly(const Held& held, int grid) {
  const auto found = held.find(grid);
  return found != held.end() && found->second.size() == 6;
}

}  // namespace

std::string ConstraintAxes::held_in_basic(int grid) const {
  const auto found = held.find(grid);
  if (found == held.end() || turned.contains(grid)) return {};
  return found->second;
}

bool ConstraintAxes::held_wholly(int grid) const {
  return holds_wholly(held, grid);
}

std::optional<std::string> along_basic(const std::string& components,
                                       const Eigen::Matrix3d& axes) {
  if (axes == Eigen::Matrix3d::Identity()) return components;
  constexpr double rounding = 1e-6;
  std::string result;
  for (const Eigen::Index kind : {Eigen::Index{0}, Eigen::Index{3}}) {
    Eigen::Matrix3d P = Eigen::Matrix3d::Zero();  // onto these directions
    for (const char digit : components) {
      const Eigen::Index axis = digit - '1' - kind;
      if (axis < 0 || axis > 2) continue;
      P += axes.col(axis) * axes.col(axis).transpose();
    }
    for (Eigen::Index i = 0; i < 3; ++i) {
      // P is a projection: its diagonal is 0 or 1 only along its own axes.
      if (std::min(std::abs(P(i, i)), std::abs(P(i, i) - 1.0)) > rounding) {
        return {};
      }
      if (P(i, i) > 0.5) result += static_cast<char>('1' + kind + i);
    }
  }
  return result;
}

std::map<int, std::string> held_by_grid(const Deck& deck) {
  Held held;
  for (const Constraint& c : deck.constraints) hold(c.grid, c.components, held);
  // A rigid element may lead the one that leads the next.
  for (bool more = !held.empty(); more;) {
    more = false;
    for (const RigidElement& e : deck.rigids) {
      if (!holds_wholly(held, e.independent)) continue;
      for (const Dependent& d : e.dependents) {
        if (hold(d.grid, d.components, held)) more = true;
      }
    }
  }
  return held;
}

ConstraintAxes constraint_axes(const Deck& deck) {
  ConstraintAxes result;
  result.held = held_by_grid(deck);
  const auto need = [&](int grid, const std::string& components) {
    if (!along_basic(components, axes_of(deck, grid))) {
      result.turned.insert(grid);
    }
  };
  for (const auto& [grid, components] : result.held) need(grid, components);
  for (const RigidElement& e : deck.rigids) {
    for (const Dependent& d : e.dependents) need(d.grid, d.components);
  }
  // What a relation gives is one component along the grid's own axes.
  for (const Relation& e : deck.relations) {
    if (axes_of(deck, e.grid) != Eigen::Matrix3d::Identity()) {
      result.turned.insert(e.grid);
    }
  }
  for (auto& [grid, components] : result.held) {
    if (result.turned.contains(grid)) continue;
    components = *along_basic(components, axes_of(deck, grid));
  }
  return result;
}

}  // namespace tapfit::structure
