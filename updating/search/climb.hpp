// Steps of one kind from place to place.
#pragma once

#include "updating/search/hypothesis.hpp"
#include "updating/search/reach.hpp"

#include <vector>

namespace tapfit::updating {

/// Adds places of what resonates. It does most to one mode, and does as well
/// wherever that moves as much: there are many tops. With what is fitted
/// besides as the best of it has it, all grids are looked at again and the best
/// of those apart are fitted, until none does better.
void look_elsewhere(std::vector<Hypothesis>& found,
                    const Fit& current,
                    const Fitter& fitter,
                    int neighbours,
                    Reach& reach,
                    const Progress& progress);

/// From the best of a kind to a likelier one around it as long as there is one,
/// and its pace may bring it near to what something reaches.
/// @param found of one kind, not empty; gets all that were looked at
/// @param reach takes what was found
void climb_places(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  int neighbours,
                  Reach& reach,
                  const Progress& progress);

/// The same from patch to patch with a layer more or less, by the error.
/// Patches are looked for as cubes; what is lost may be a long one. What a
/// patch is short of looks like an error of form to the likelihood, which sees
/// no way on; the error falls with every layer that belongs to it.
void climb_shapes(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  Reach& reach,
                  const Progress& progress);

/// The same from crack to crack: one begins and ends at some grid of its line.
/// By the error, too, as one that is too short still leaves much.
void climb_cracks(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  Reach& reach,
                  const Progress& progress);

}  // namespace tapfit::updating
