// Looking on while a fit runs: a FitObserver is told of every step, and may
// have the fit end with what it has reached.
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
struct IterationSummary {
  const UpdateStep& step;
  const FrfModel& model;
  const Target& target;
  const Prior& prior;
  const ModelState& state;
  const Eigen::MatrixXcd& H;          ///< the model's, on the target's lines
  const Eigen::MatrixXd& covariance;  ///< of theta
};

struct FitObserver : Observer {
  std::function<void(const IterationSummary& summary)> step;
  std::function<bool()> enough;  ///< true: end now, keep what is reached
  /// Of a diagnosis what its first look has fitted nearly to the end, and again
  /// what of it to the end: one at a time, from any thread.
  std::function<void(const Candidate& candidate)> tried;
};

/// Whoever looks on at a fit, or none.
[[nodiscard]] inline const FitObserver* fit_observer(const Progress& progress) {
  return dynamic_cast<const FitObserver*>(progress.observer.get());
}

/// Whether an observer has seen enough.
[[nodiscard]] inline bool is_enough(const Progress& progress) {
  const FitObserver* observer = fit_observer(progress);
  return observer != nullptr && observer->enough && observer->enough();
}

/// As part_of(), but an observer still looks on.
[[nodiscard]] inline Progress observed_part(const Progress& whole,
                                            double from,
                                            double to) {
  Progress part = part_of(whole, from, to);
  part.observer = whole.observer;
  return part;
}

}  // namespace tapfit::updating
