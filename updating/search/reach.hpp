// What the rest of the way is worth: hypotheses and climbs that cannot come
// near to what something else reaches end early.
#pragma once

#include "updating/search/hypothesis.hpp"

#include <limits>

namespace tapfit::updating {

class Reach {
 public:
  /// Of what is added to a fit: how likely it is tell the data in what that
  /// fit leaves, which evidence counts as well.
  Reach(const Fit& current, const Fitter& fitter);

  /// @param data N, independent ones
  /// @param noise relative error that the scatter over hits alone would give
  Reach(double data, double noise) : data_(data), noise_(noise) {}

  /// The hypothesis of a fit, with its likelihood.
  [[nodiscard]] Hypothesis judged(Fit fit) const;

  /// Something reaches this.
  /// @param of as judged, as everywhere below
  void take(const Hypothesis& of);

  /// The same of a fit that is known beforehand: from the first lines on,
  /// others are measured by it.
  void take_known(const Fit& fit, const Fitter& fitter);

  /// An error on the wide lines from which nothing comes near to what is known;
  /// infinite where nothing is.
  [[nodiscard]] double hopeless_wide_error() const;

  /// The same of what the screening thinks would be left.
  [[nodiscard]] double hopeless_screened_error() const;

  /// Far less likely than what something reaches, and with more error.
  [[nodiscard]] bool is_hopeless(const Hypothesis& of) const;

  /// Whether steps from place to place may come near, at the pace of the last.
  /// @param steps that may follow
  [[nodiscard]] bool holds_way(const Hypothesis& before,
                               const Hypothesis& now,
                               int steps) const;

 private:
  double data_;
  double noise_;
  double most_ = -1e300;
  double least_error_ = 1e300;
  double known_wide_ = std::numeric_limits<double>::infinity();
};

}  // namespace tapfit::updating
