// Windows for hammer tests.
//
//   force:        rectangle around the pulse with cosine tapers, then zero
//   exponential:  exp(-sigma t), t = 0 at the trigger, on force AND response
//
// With the same exponential on both, the ratio of the transforms is the
// transfer function on s = sigma + j omega: the integral of
// y(t) exp(-sigma t) exp(-j omega t) is the Laplace transform Y(s), and
// Y(s) = H(s) F(s). What the block's end cuts off is exp(-sigma T) of the
// response that is left by then.
//
// Source: W. Fladung, R. Rost, "Application and correction of the exponential
// window for frequency response functions", MSSP 11(1), 1997, p. 23-36.
#pragma once

#include <Eigen/Core>

namespace tapfit::signal {

/// Rows of a block that the force pulse takes up.
struct PulseSpan {
  Eigen::Index begin = 0;  ///< first row of the pulse
  Eigen::Index end = 0;    ///< one past its last row
};

/// Finds the pulse around the trigger: from the first to the last sample that
/// pushes in the pulse's direction by more than the noise. Small bounces after
/// the pulse are force too and belong to it; a sensor's slow undershoot is
/// none and does not.
///
/// @param force one block, offset removed [N]
/// @param trigger row of the trigger
/// @param pulse_samples width of the main pulse
/// @param noise_rms of the force before the hit [N]
/// @return a span with the trigger in it, at most a tenth of the block behind
[[nodiscard]] PulseSpan find_pulse(
    const Eigen::Ref<const Eigen::VectorXd>& force,
    Eigen::Index trigger,
    Eigen::Index pulse_samples,
    double noise_rms);

/// Leaves the rows inside the span, fades those of `taper` samples on either
/// side along a cosine, and sets all beyond to zero.
void apply_pulse_window(const PulseSpan& span,
                        Eigen::Index taper,
                        Eigen::Ref<Eigen::VectorXd> block);

/// Zero until the pulse's taper begins, then as apply_pulse_window, and the
/// rest of the block left as it is: nothing that this hit caused happens before
/// it.
void apply_causal_window(const PulseSpan& span,
                         Eigen::Index taper,
                         Eigen::Ref<Eigen::VectorXd> block);

/// exp(-sigma t) with t = 0 at row `trigger`.
///
/// @param dt sampling interval [s]
/// @param sigma decay rate [1/s], at least 0
[[nodiscard]] Eigen::VectorXd exponential_window(Eigen::Index block,
                                                 Eigen::Index trigger,
                                                 double dt,
                                                 double sigma);

/// Decay rate that takes the window from 1 to end_value in `seconds`.
///
/// @throws InputError unless 0 < end_value <= 1
[[nodiscard]] double decay_rate(double end_value, double seconds);

}  // namespace tapfit::signal
