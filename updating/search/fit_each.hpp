// Fits of several hypotheses in two passes: each as far as shows how likely it
// ends, then to the end what may be the answer.
#pragma once

#include "updating/search/hypothesis.hpp"
#include "updating/search/reach.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace tapfit::updating {

[[nodiscard]] bool less_error(const Hypothesis& a, const Hypothesis& b);
[[nodiscard]] bool is_likelier(const Hypothesis& a, const Hypothesis& b);

/// One base for all of several effects that do not change the stiffness.
[[nodiscard]] std::shared_ptr<const FrfModel> shared_base(
    const Fit& current,
    const std::vector<EffectInstance>& tries,
    const Fitter& fitter);

/// The first pass, for the present effects and one more; nothing where it is
/// given up on the way.
/// @param shared its base; null: it gets its own
[[nodiscard]] std::optional<Hypothesis> approach_one(
    const Fit& current,
    const EffectInstance& more,
    const Fitter& fitter,
    const std::shared_ptr<const FrfModel>& shared,
    const Reach& reach,
    const Progress& progress);

/// Of the first pass, without what was given up.
[[nodiscard]] std::vector<Hypothesis> those_left(
    std::vector<std::optional<Hypothesis>> approached);

/// The second pass.
/// @return with no jacobian: there are too many of them to keep it
[[nodiscard]] Hypothesis arrive(Hypothesis approached,
                                const Fitter& fitter,
                                const Reach& reach,
                                const Progress& progress);

/// What the second pass is not worth: all that is hopeless, but for the
/// likeliest of these and that with the least error.
void drop_hopeless(std::vector<Hypothesis>& found, const Reach& reach);

/// Both passes for each of several; those that end at what there is not are
/// left out, and those out of reach.
/// @param reach takes what both passes reach
[[nodiscard]] std::vector<Hypothesis> fit_each(
    const Fit& current,
    const std::vector<EffectInstance>& extras,
    const Fitter& fitter,
    Reach& reach,
    const Progress& progress);

/// Each from where a fit of the same ended at a place beside: near enough to be
/// fitted to the end at once.
/// @param shared one base for all of them; null: each gets its own
[[nodiscard]] std::vector<Hypothesis> fit_each_beside(
    const Fit& beside,
    const Fit& current,
    const std::vector<EffectInstance>& extras,
    const Fitter& fitter,
    const std::shared_ptr<const FrfModel>& shared,
    const Reach& reach,
    const Progress& progress);

}  // namespace tapfit::updating
