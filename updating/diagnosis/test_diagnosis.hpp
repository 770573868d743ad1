// The diagnosis of a whole test: of its FRFs, and what its modes and its model
// have to say besides.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fit_context.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// How thoroughly it looks, and what it knows of the error.
[[nodiscard]] DiagnoseOptions options_of_test(const FitContext& ground);

/// @param current the model's fit; with nothing added the ground's base
/// @param base the comparison of the deck as it is
/// @param of_model warnings of the model, put last
[[nodiscard]] Diagnosis diagnose_test(const FitContext& ground,
                                      const Fit& current,
                                      const Comparison& base,
                                      const MeasuredTest& test,
                                      const std::vector<std::string>& of_model,
                                      const Progress& progress);

/// A ladder cut where the deck's own numbers end: they come first, and all else
/// is a diagnosis of the deck put right.
struct TwofoldDiagnosis {
  std::vector<EffectInstance> corrections;  ///< of the deck
  std::string named;                        ///< "card-swap"; empty: none
  Diagnosis rest;                           ///< ladder and verdict without them
};
[[nodiscard]] TwofoldDiagnosis cut_at_deck(Diagnosis diagnosis,
                                           const effects::TestContext& context);

/// "card-swap" with what a diagnosis of the deck put right comes to.
[[nodiscard]] std::string with_named(const std::string& named,
                                     const std::string& verdict);

}  // namespace tapfit::updating
