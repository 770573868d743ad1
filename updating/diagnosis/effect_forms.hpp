// Forms of an effect that is in the model already: two motions of a support
// that are one, and a form that turns out to be the plain effect.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"

#include <cstddef>
#include <optional>

namespace tapfit::updating {

/// Two motions of one support as one effect, with the sizes they have; nothing
/// where they are no such motions.
[[nodiscard]] std::optional<EffectInstance> both_of(
    const EffectInstance& one,
    const EffectInstance& other,
    const effects::TestContext& context);

/// A form that made up for effects that were not known then, once they are: the
/// fit with the plain effect in its place, where it is as likely.
/// @param k which of the fit's effects
/// @return nothing where it has no form, or needs it
[[nodiscard]] std::optional<Fit> in_plain_form(const Fit& fit,
                                               std::size_t k,
                                               const Fitter& fitter,
                                               const Progress& progress);

}  // namespace tapfit::updating
