// An effect of the catalogue, by name, at a place.
#pragma once

#include "updating/places/location.hpp"

#include <string>

namespace tapfit::updating {

struct EffectRef {
  std::string effect;
  Location where;

  bool operator==(const EffectRef&) const = default;
};

/// "added-mass at node 201"; the effect alone where it has no place.
[[nodiscard]] std::string effect_text(const std::string& effect,
                                      const Location& where);

/// Of a candidate that no linear model holds: it cannot be added.
inline constexpr const char* nonlinearity = "nonlinearity";

}  // namespace tapfit::updating
