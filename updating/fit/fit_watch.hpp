// Looking on while a fit runs. A FitWatch put into Progress::report is told of
// every step besides, and may have the fit end with what it has reached: all
// else that takes a Progress need not know of it.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/fit/update_history.hpp"

#include <Eigen/Core>

#include <functional>
#include <string_view>
#include <utility>

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

struct FitWatch {
  std::function<void(std::string_view stage, double fraction)> report;
  std::function<void(const FitMoment& moment)> step;
  std::function<bool()> enough;  ///< true: end now, keep what is reached
  /// Of a diagnosis what its first look has fitted to the end: one at a time,
  /// from any thread.
  std::function<void(const Candidate& candidate)> tried = {};

  void operator()(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
  }
};

/// The watch that wants to be told of steps, if there is one.
[[nodiscard]] inline const FitWatch* watch_of(const Progress& progress) {
  const auto* watch = progress.report.target<FitWatch>();
  return watch != nullptr && watch->step ? watch : nullptr;
}

/// Whether a watch has seen enough.
[[nodiscard]] inline bool is_enough(const Progress& progress) {
  const auto* watch = progress.report.target<FitWatch>();
  return watch != nullptr && watch->enough && watch->enough();
}

/// As part_of(), but a watch is still told of the part's steps.
/// @param whole outlives the part
[[nodiscard]] inline Progress watched_part(const Progress& whole,
                                           double from,
                                           double to) {
  Progress part = part_of(whole, from, to);
  const auto* watch = whole.report.target<FitWatch>();
  if (watch == nullptr) return part;
  FitWatch inner{std::move(part.report), {}, {}};
  // Asked itself, no copy: it may count.
  if (watch->step) inner.step = [watch](const FitMoment& m) { watch->step(m); };
  if (watch->enough) inner.enough = [watch] { return watch->enough(); };
  part.report = std::move(inner);
  return part;
}

}  // namespace tapfit::updating
