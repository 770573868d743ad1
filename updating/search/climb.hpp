// Fits of one kind at places, and steps from place to place.
#pragma once

#include "updating/search/hypothesis.hpp"

#include <memory>
#include <vector>

namespace tapfit::updating {

/// Fits the present effects and one more.
/// @param shared its base; null: it gets its own
/// @param beside a fit of the same at a place beside, from which it goes on
[[nodiscard]] Fit fit_one(const Fit& current,
                          const PlacedEffect& more,
                          const Fitter& fitter,
                          const std::shared_ptr<const FrfModel>& shared,
                          const Progress& progress,
                          const Fit* beside = nullptr);

/// The same for each of several; those that end at what there is not are left
/// out.
/// @param shared one base for all of them; null: each gets its own
[[nodiscard]] std::vector<Hypothesis> fit_each(
    const Fit& current,
    const std::vector<PlacedEffect>& extras,
    const Fitter& fitter,
    const std::shared_ptr<const FrfModel>& shared,
    const Progress& progress,
    const Fit* beside = nullptr);

[[nodiscard]] bool less_error(const Hypothesis& a, const Hypothesis& b);
[[nodiscard]] bool is_likelier(const Hypothesis& a, const Hypothesis& b);

/// From the best of a kind to a likelier one around it as long as there is one.
/// @param found of one kind, not empty; gets all that were looked at
void climb_places(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  int neighbours,
                  const Progress& progress);

/// The same from patch to patch with a layer more or less, by the error.
/// Patches are looked for as cubes; what is lost may be a long one. What a
/// patch is short of looks like an error of form to the likelihood, which sees
/// no way on; the error falls with every layer that belongs to it.
void climb_shapes(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  const Progress& progress);

/// The same from crack to crack: one begins and ends at some grid of its line.
void climb_cracks(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  const Progress& progress);

}  // namespace tapfit::updating
