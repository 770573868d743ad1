// The room updating/diagnosis. Which effect is missing, where, how large and
// how sure: hypotheses fitted, ranked by evidence, the error ladder climbed.
// In:  Fits of one test.
// Out: Diagnosis with candidates, ladder, verdict and the next measurement.
// May include: its row in CONTRIBUTING.md.
//
// Ranks what may be missing from the model and climbs the error ladder: add
// the best, refit everything, look again, stop when nothing earns its place.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// @param present effects already in the model; their fit is the start
[[nodiscard]] Diagnosis diagnose(const Fitter& fitter,
                                 const std::vector<EffectInstance>& present,
                                 const DiagnoseOptions& options,
                                 const Progress& progress = {});

}  // namespace tapfit::updating
