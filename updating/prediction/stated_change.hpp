// A change of the structure that is known before it is made: an effect of the
// catalogue at a place, with its size,
//
//   NAME[@PLACE]=SIZE[,SIZE ...]
//
// one size for each of its parameters in their order, in SI units or with a
// unit behind it: "added-mass@201=0.010", "added-mass@201=10g",
// "added-mass@201:rotary=0.010,2e-6", "stiffness-loss@60:61=80%".
#pragma once

#include "updating/effects/effect_instance.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct StatedSize {
  double value = 0.0;
  std::string unit = {};  ///< empty: SI

  bool operator==(const StatedSize&) const = default;
};

struct StatedChange {
  EffectRef ref;
  std::vector<StatedSize> sizes;

  bool operator==(const StatedChange&) const = default;
};

/// @throws InputError for an effect that is not known or no change of the
///   structure (a mistake of the set-up, a law of damping), an empty place, a
///   size that is missing or no number
[[nodiscard]] StatedChange parse_stated_change(const std::string& text);

/// The change at its place in this model, its sizes in SI units.
/// @throws InputError for a place that the model does not have, another number
///   of sizes than the effect has parameters, a unit that is none of theirs, a
///   size that is not above zero
[[nodiscard]] EffectInstance place_change(const StatedChange& change,
                                          const effects::TestContext& context);

/// Whether the model can hold a change of that size.
/// @param model whose base holds the change
/// @throws InputError with the range where it cannot
void check_size(const EffectInstance& change, const FrfModel& model);

/// "added-mass at node 201, mass_kg 0.01".
[[nodiscard]] std::string change_text(const EffectInstance& change,
                                      const effects::TestContext& context);

}  // namespace tapfit::updating
