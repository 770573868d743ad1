// What a diagnosis would say of fits that were made again, by its own rules:
// each rung must stay worth its place, is named by the kinds that are not told
// apart, and what came closest on top may have earned a place.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/robustness/refits.hpp"

#include <string>

namespace tapfit::updating {

/// @param fitter that made the fits
/// @param options their floor is that of the fitter's target
/// @param before the diagnosis; its ladder is that of the fits
[[nodiscard]] std::string verdict_of(const Refits& refits,
                                     const Fitter& fitter,
                                     const DiagnoseOptions& options,
                                     const Diagnosis& before,
                                     const Progress& progress);

}  // namespace tapfit::updating
