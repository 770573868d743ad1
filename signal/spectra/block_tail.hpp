// What a response still does when its block ends.
//
//   x(t) = c + sum_r Re(a_r exp(lambda_r (t - T))),   no force any more
//   sum_{t_n >= T} x_n exp(-s t_n)
//     = exp(-s T) sum_r (a_r / (1 - exp((lambda_r - s) dt))
//                        + conj(a_r) / (1 - exp((conj(lambda_r) - s) dt))) / 2
//
// with known poles lambda_r. The amplitudes are fitted to the later half of the
// block behind the trigger, where faster modes have died out; the offset c is
// none of the response. On a line s = sigma + j omega the sum carries the
// weight exp(-sigma T), as the block does: it completes windowed transforms
// just as it does those without a window.
#pragma once

#include <Eigen/Core>

#include <string>

namespace tapfit::signal {

/// Free decays behind the end of a run's blocks, one sensor's.
struct BlockTail {
  Eigen::VectorXcd poles;       ///< [rad/s], Re < 0, Im > 0; none: no tail
  Eigen::MatrixXcd amplitudes;  ///< poles x hits, at the block's end
};

/// Fits the decays of one sensor's blocks.
///
/// @param blocks block x hits, no exponential window applied
/// @param trigger row at which t = 0
/// @param dt sampling interval [s]
/// @param poles of modes that outlast the block [rad/s]
/// @return no poles where half of the block holds less than two periods of the
///   slowest, or too few samples
[[nodiscard]] BlockTail fit_tail(const Eigen::MatrixXd& blocks,
                                 Eigen::Index trigger,
                                 double dt,
                                 const Eigen::VectorXcd& poles);

/// The sum over all samples from the block's end on, lines x hits.
///
/// @param s lines [rad/s], Re(s) >= 0
/// @param kernel exp(-s T) of each line, by the time the transform counts in
/// @param dt as for fit_tail
[[nodiscard]] Eigen::MatrixXcd tail_spectra(const BlockTail& tail,
                                            const Eigen::VectorXcd& s,
                                            const Eigen::VectorXcd& kernel,
                                            double dt);

/// What was done about modes that outlast the block; empty without any.
///
/// @param poles [rad/s]
/// @param seconds from trigger to the block's end
[[nodiscard]] std::string tail_statement(const Eigen::VectorXcd& poles,
                                         double seconds);

}  // namespace tapfit::signal
