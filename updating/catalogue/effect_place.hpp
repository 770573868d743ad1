// From what a user writes, "added-mass@201", to an effect at a place of this
// test's model.
#pragma once

#include "updating/effects/effect_instance.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// "added-mass@201", "sensor-mass", "sensor-mass@acc1:acc2:each",
/// "soft-support@rotation".
///
/// @throws InputError for an unknown effect or an empty place
[[nodiscard]] EffectRef parse_effect(const std::string& text);

/// The effect's forms at those of the places that take them, each once.
[[nodiscard]] std::vector<Location> forms_of(
    const effects::Effect& effect,
    const std::vector<Location>& places,
    const effects::TestContext& context);

/// The catalogue's place that the reference means, with starting sizes: fields
/// that it leaves open are filled from the first place that agrees with those
/// it gives; the grid of a sheet only where it has the channel at no other.
///
/// @throws InputError when the effect has no such place in this model
[[nodiscard]] EffectInstance place_effect(const EffectRef& ref,
                                          const effects::TestContext& context);

}  // namespace tapfit::updating
