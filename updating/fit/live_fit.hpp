// What a fit looks like after a step, for those who watch it run.
#pragma once

#include "updating/fit/fit_observer.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct LiveParameter {
  std::string name;  ///< "E:1", "added-mass mass_kg"
  double value = 0.0;
  double sd = 0.0;
  double lower = 0.0;  ///< bounds of the fit
  double upper = 0.0;
};

struct LiveFit {
  double error = 0.0;  ///< on the lines that the step was taken on
  std::vector<LiveParameter> parameters;  ///< damping left out
  /// One FRF on those lines; accelerance, magnitudes.
  std::size_t frf = 0;
  Eigen::VectorXd frequency_hz;
  Eigen::VectorXd measured;
  Eigen::VectorXd model;
};

/// @param frf the FRF to look at; empty: the one with the largest error
[[nodiscard]] LiveFit live_fit(const IterationSummary& summary,
                               std::optional<std::size_t> frf);

}  // namespace tapfit::updating
