// Which frequency lines an updating without damped lines uses. Near a
// resonance a small shift of frequency changes an undamped FRF without bound;
// the paper's section 4.1.3 compares three choices and its 2.3 gives a rule.
#pragma once

#include "acquisition/foundation/seeded_random.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace tapfit::updating {

/// Case 1: a line every `step_hz`, from step_hz up to the band's end.
[[nodiscard]] Eigen::VectorXd even_lines(double high_hz, double step_hz);

/// Case 2: `count` lines anywhere in the band, ascending.
[[nodiscard]] Eigen::VectorXd random_lines(double high_hz,
                                           int count,
                                           acquisition::SeededRandom& random);

/// Case 3: `count` lines `step_hz` apart from `before_hz` to the left of each
/// resonance on.
[[nodiscard]] Eigen::VectorXd lines_before_peaks(
    const Eigen::VectorXd& resonances_hz,
    double before_hz = 10.0,
    double step_hz = 0.5,
    int count = 8);

/// The rule of section 2.3.
struct PeakRule {
  double around_hz = 4.0;  ///< width of the gap around a resonance
  double close_hz = 0.0;   ///< resonances closer than this: nothing between
};

/// Whether each line may be used beside the resonances of the measurement and
/// of the model as it is. Between a resonance of the measurement and the same
/// one of the model nothing is used either: the FRFs there have opposite sign.
///
/// @param measured_hz, model_hz ascending, the same modes
[[nodiscard]] std::vector<bool> off_peaks(const Eigen::VectorXd& lines_hz,
                                          const Eigen::VectorXd& measured_hz,
                                          const Eigen::VectorXd& model_hz,
                                          const PeakRule& rule);

}  // namespace tapfit::updating
