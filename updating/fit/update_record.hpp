// What there is to say of one fit besides its result: how it converged, which
// parameters the data tell apart and how the estimates hang together.
#pragma once

#include "updating/places/location.hpp"
#include "updating/residual/identifiability.hpp"
#include "updating/residual/l_curve.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::effects {
struct TestContext;
}

namespace tapfit::updating {

struct Fit;
struct PropertyName;

struct RecordedStep {
  int stage = 0;           ///< each begins where the last ended, on other lines
  double error = 0.0;      ///< of the residual that is brought down
  double length = 0.0;     ///< largest relative change of a parameter
  double lambda = 0.0;     ///< regularisation
  Eigen::VectorXd values;  ///< of UpdateRecord::parameters
};

struct UpdateRecord {
  std::string added;  ///< as of the rung
  Location where;
  std::string lines;  ///< in words
  bool converged = false;
  std::string message;  ///< why it stopped
  /// Uncertain properties, then "EFFECT NAME"; the damping is left out.
  std::vector<std::string> parameters;
  std::vector<RecordedStep> steps;  ///< of each stage its start first
  /// Of the first step where lambda was a choice, of the last one where the
  /// priors gave it; none where nothing has a prior.
  std::optional<LCurve> l_curve;
  Identifiability identifiability;  ///< from the data alone, damping along
  /// Groups of names that the data cannot tell apart.
  std::vector<std::vector<std::string>> confounded;
  Eigen::MatrixXd correlation;  ///< of the estimates, prior included
};

/// @param fit that identified something
/// @param lines what it was fitted on, in words
[[nodiscard]] UpdateRecord record_of(const Fit& fit,
                                     const effects::TestContext& context,
                                     const std::vector<PropertyName>& names,
                                     const std::string& lines);

/// Of successive fits, but for the first: the base, to which nothing is fitted.
[[nodiscard]] std::vector<UpdateRecord> records_of(
    const std::vector<Fit>& fits,
    const effects::TestContext& context,
    const std::vector<PropertyName>& names,
    const std::string& lines);

}  // namespace tapfit::updating
