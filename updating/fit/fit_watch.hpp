// Looking on while a fit runs: a FitWatch is told of every step, and may have
// the fit end with what it has reached.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/fit/update_history.hpp"

#include <Eigen/Core>

#include <functional>

namespace tapfit::updating {

class FrfModel;
struct Candidate;
struct ModelState;
struct Prior;
struct Target;

/// A fit just after a step; nothing of it outlives the call.
struct FitMoment {
  const UpdateStep& step;
  const FrfModel& model;
  const Target& target;
  const Prior& prior;
  const ModelState& state;
  const Eigen::MatrixXcd& H;          ///< the model's, on the target's lines
  const Eigen::MatrixXd& covariance;  ///< of theta
};

struct FitWatch : Watch {
  std::function<void(const FitMoment& moment)> step;
  std::function<bool()> enough;  ///< true: end now, keep what is reached
  /// Of a diagnosis what its first look has fitted to the end: one at a time,
  /// from any thread.
  std::function<void(const Candidate& candidate)> tried;
};

/// Whoever looks on at a fit, or none.
[[nodiscard]] inline const FitWatch* fit_watch(const Progress& progress) {
  return dynamic_cast<const FitWatch*>(progress.watch.get());
}

/// Whether a watch has seen enough.
[[nodiscard]] inline bool is_enough(const Progress& progress) {
  const FitWatch* watch = fit_watch(progress);
  return watch != nullptr && watch->enough && watch->enough();
}

/// As part_of(), but a watch still looks on.
[[nodiscard]] inline Progress watched_part(const Progress& whole,
                                           double from,
                                           double to) {
  Progress part = part_of(whole, from, to);
  part.watch = whole.watch;
  return part;
}

}  // namespace tapfit::updating
