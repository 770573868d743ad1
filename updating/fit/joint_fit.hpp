// Several tests fitted together: what they share is one number in all of them.
//
//   J(theta) = sum_i N_i ln ||r_i(theta)||^2 + sum ((theta - mean) / sd)^2
//
// theta is what is shared, then what each test has for itself: its damping, its
// own properties and effects. To the minimiser it is one residual,
// sqrt(N_i) r_i / ||r_i|| of each test with the norms as they were, taken anew
// until nothing moves: there the gradient is that of J.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// One of the tests, fitted by itself.
struct JointTest {
  const Fitter* fitter = nullptr;
  Fit alone;  ///< where it starts from
  /// Of each parameter of pack(): the number of what is shared, or its own.
  std::vector<std::optional<std::size_t>> shared;
  /// Of each: its theta less that of the first test which shares it, as of two
  /// decks that have different values of one property.
  Eigen::VectorXd offset;
  /// Tests with the same number have one deck, wrong by the same in its form.
  int structure = 0;
};

struct JointFit {
  /// Each test's, with the sizes of the joint minimum; its covariance is of
  /// what all tests together tell.
  std::vector<Fit> fits;
  bool converged = false;
  std::string message;  ///< why it stopped
};

/// What is shared has the prior and the bounds of the first test that has it.
/// @param tests two or more
[[nodiscard]] JointFit fit_together(std::vector<JointTest> tests,
                                    const Progress& progress = {});

/// Whether estimates of one number agree: Cochran's Q,
///
///   Q = sum (x_i - mean)^2 / variance_i,  mean weighted by 1 / variance_i,
///
/// chi^2 with one degree of freedom less than there are estimates. Source:
/// W. G. Cochran, "The combination of estimates from different experiments",
/// Biometrics 10, 1954, p. 101.
struct Agreement {
  double q = 0.0;
  int degrees = 0;
  double probability = 1.0;  ///< of as much by chance
};

/// @param variance of each, above 0
[[nodiscard]] Agreement agreement(const Eigen::VectorXd& estimates,
                                  const Eigen::VectorXd& variance);

}  // namespace tapfit::updating
