// The model of a fit before and after changes whose sizes are known. Both are
// one base, which holds what the changes act on, so that their modes compare;
// what the mesh does to the modes is taken at each state.
#pragma once

#include "updating/fit/fitter.hpp"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace tapfit::updating {

struct ChangedModel {
  std::shared_ptr<const FrfModel> now;
  std::shared_ptr<const FrfModel> after;
  ModelState state;                     ///< of the fit: now
  std::vector<EffectInstance> changes;  ///< what is added to it

  /// The state after the changes, with other parameters of the fit.
  /// @param theta as pack(state)
  [[nodiscard]] ModelState changed(const Eigen::VectorXd& theta) const;
  [[nodiscard]] ModelState changed() const { return changed(pack(state)); }
};

/// @throws InputError for a size out of range, a change of stiffness that is an
///   effect of the fit as well
[[nodiscard]] ChangedModel changed_model(
    const Fit& fit,
    const Fitter& fitter,
    const std::vector<EffectInstance>& changes);

/// Of the parameters of the fit, ln; zero where nothing was fitted. What the
/// data say nothing of is anywhere in its bounds, not beyond.
[[nodiscard]] Eigen::MatrixXd parameter_spread(const Fit& fit);

}  // namespace tapfit::updating
