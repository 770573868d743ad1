// What all fits of one test stand on: the solved model, the measured FRFs on
// damped lines, the model as the deck has it, and the error's floor.
#pragma once

#include "updating/fit/fit_problem.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// The deck's model solved; where it is small enough, on elements split once
/// more too, so that what the mesh does to the modes is known.
struct SolvedModel {
  BaseBuilder builder;                ///< split where that is affordable
  std::optional<BaseBuilder> coarse;  ///< the deck's own elements, if split
  std::vector<Correction> corrections = {};  ///< of `builder`, if split
  std::string why_not_split = {};  ///< empty where split, or without a mesh

  [[nodiscard]] const BaseBuilder& unsplit() const {
    return coarse ? *coarse : builder;
  }
};

/// @param high_hz upper end of the band that the model must hold
/// @throws InputError for a deck that has no modes
[[nodiscard]] SolvedModel solve_model(const structure::Deck& deck,
                                      const acquisition::TestBundle& bundle,
                                      double high_hz,
                                      const Progress& progress);

/// @return empty where the mesh's share of the floor is known, or there is no
///   mesh
[[nodiscard]] std::string mesh_warning(const SolvedModel& model);

struct FitContext {
  std::unique_ptr<Fitter> fitter;
  std::string contour;                   ///< the damped lines in words
  std::vector<PropertyName> properties;  ///< that are fitted along
  Fit base;                              ///< nothing fitted
  double floor_noise = 0.0;              ///< of the error, from the hits
  double floor_mesh = 0.0;               ///< of the error, from the mesh
};

/// @param model must outlive the result
[[nodiscard]] FitContext prepare_fits(const SolvedModel& model,
                                      const MeasuredTest& test,
                                      const Progress& progress);

}  // namespace tapfit::updating
