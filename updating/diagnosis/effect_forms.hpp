// Forms of an effect that is in the model already: two motions of a support or
// two sensors' masses that are one effect, a form that turns out to be the
// plain one, and a gain that turns out to be a unit.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"

#include <cstddef>
#include <optional>

namespace tapfit::updating {

/// Two motions of one support, or the same of some sensors and of others, as
/// one effect with the sizes they have, the fewest parameters first; empty
/// where they are no such two.
[[nodiscard]] std::vector<EffectInstance> both_of(
    const EffectInstance& one,
    const EffectInstance& other,
    const effects::TestContext& context);

/// A form that made up for effects that were not known then, once they are, or
/// a gain that made up for the rest of what is wrong: the fit with the plain
/// effect or with the unit in its place, where it is as likely.
/// @param k which of the fit's effects
/// @return nothing where it has no form, or needs it
[[nodiscard]] std::optional<Fit> in_plain_form(const Fit& fit,
                                               std::size_t k,
                                               const Fitter& fitter,
                                               const Progress& progress);

}  // namespace tapfit::updating
