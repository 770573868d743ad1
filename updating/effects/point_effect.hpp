// What effects at one grid share: they may sit at any grid of the deck that
// belongs to the structure.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

/// Base of the effects that act at one grid.
class PointEffect : public Effect {
 public:
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
};

/// The three translations of a grid.
[[nodiscard]] std::vector<ActedDof> translations(int node);

}  // namespace tapfit::effects
