// What effects at one grid share: they may sit at any grid of the deck that
// belongs to the structure.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

/// Base of the effects that act at one grid.
class PointEffect : public Effect {
 public:
  using Effect::Effect;
  [[nodiscard]] std::vector<Location> places(
      const TestContext& context) const override;
};

/// Base of those that act along one axis: the direction mostly measured, or,
/// where the test has others, one of these as well. Where::variant "X", "Y" or
/// "Z" names it; empty for the direction mostly measured.
class DirectedEffect : public PointEffect {
 public:
  DirectedEffect(std::string name, std::string words, Law law);
  /// Every grid along the direction mostly measured, then along the others.
  [[nodiscard]] std::vector<Location> places(
      const TestContext& context) const override;
  /// Other axes are places of their own, not forms of what was found.
  [[nodiscard]] bool takes(const std::string&,
                           const Location&,
                           const TestContext&) const override {
    return false;
  }
  [[nodiscard]] std::vector<InterfaceDof> interface_dofs(
      const Location& where,
      const TestContext& context,
      std::size_t run) const override;
};

/// 1..3: the axis that a directed effect acts along.
[[nodiscard]] int component_of(const Location& where,
                               const TestContext& context);

/// The motion of a place, a grid or between grids, along an axis.
[[nodiscard]] InterfaceDof motion_of(const Location& where,
                                     int component,
                                     const TestContext& context);

/// Its three translations.
[[nodiscard]] std::vector<InterfaceDof> translations(
    const Location& where, const TestContext& context);

}  // namespace tapfit::effects
