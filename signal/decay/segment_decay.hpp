// How the level at a line goes on through a block: as decays make it, or with
// something that comes anew.
//
// The block behind the trigger is transformed in segments of an eighth, half
// over each other, all under Hann windows. Of a sum of p decays (a tone that
// lasts is one that does not decay) a line z_k of segment k is
//
//   z_k = sum_r c_r q_r^k,  q_r = exp(lambda_r h),  h from segment to segment,
//
// whatever the window, so that each z is the same combination of the p before
// it (G. R. de Prony, 1795). What wind, machines or people excite is none: on
// the structure's own resonance, too, its level rises and falls at random. But
// what it excites there decays as the response to the blow does,
//
//   z_k = q z_{k-1} + e_k
//
// with e_k of what came since, so that least squares over all segments gives q
// and how well it is known (an autoregression of the first order; G. E. P. Box,
// G. M. Jenkins, "Time Series Analysis", 1970). A line through the levels would
// follow the bend into what is there all the time, and find too slow a decay.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit::signal {

/// What follows the blow, up to where something else is louder.
struct DecayEstimate {
  double rate = 0.0;   ///< of the decay [1/s]
  double most = 0.0;   ///< two standard deviations above it [1/s]
  double end_s = 0.0;  ///< behind the trigger; middle of the last segment
};

struct SegmentDecay {
  /// Up to three decays tell all of it, or it cannot be told.
  bool decays = true;
  /// The same level from beginning to end, within 2 dB.
  bool steady = false;
  /// Empty where it does not surely decay, or falls by less than 6 dB before
  /// something else is louder.
  std::optional<DecayEstimate> fall;
};

/// The segments of one response.
class Segments {
 public:
  /// @param response from the trigger to the block's end [SI]
  /// @param dt sampling interval [s]
  Segments(const Eigen::Ref<const Eigen::VectorXd>& response, double dt);

  /// @param noise mean square of a line of noise over the sum of the squared
  ///   window [SI^2]
  [[nodiscard]] SegmentDecay course(double hz, double noise) const;

 private:
  double dt_;
  Eigen::Index length_;  ///< of a segment
  Eigen::Index hop_;
  Eigen::MatrixXcd lines_;  ///< lines x segments
  double window_power_ = 0.0;
};

}  // namespace tapfit::signal
