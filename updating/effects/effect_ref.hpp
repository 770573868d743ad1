// An effect of the catalogue, by name, at a place.
#pragma once

#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct EffectRef {
  std::string effect;
  Location where;
  // How it was found is not what it is: two that differ in this alone are
  // equal.
  /// Of the logarithms of its parameters, for not knowing its place better;
  /// empty where it is known, or was not looked at.
  std::vector<double> place_sd = {};
  /// Where a fit of its parameters starts; empty: as its kind does.
  std::vector<double> start = {};

  bool operator==(const EffectRef& other) const {
    return effect == other.effect && where == other.where;
  }
};

/// "added-mass at node 201"; the effect alone where it has no place.
[[nodiscard]] std::string effect_text(const std::string& effect,
                                      const Location& where);

/// Of a candidate that no linear model holds: it cannot be added.
inline constexpr const char* nonlinearity = "nonlinearity";

}  // namespace tapfit::updating
