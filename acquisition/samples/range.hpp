// The room acquisition/samples. What is done to the samples of one channel,
// whatever they measure: range, where it rests, values between samples, the
// recorder's filter, decay octave by octave.
// In:  A column of samples, at most with its sampling rate.
// Out: Numbers, or views that copy nothing.
// May include: its row in CONTRIBUTING.md.
//
// Lowest and highest value of many samples in one pass, whole or by pieces.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace tapfit::acquisition {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// @param x finite values; none give an empty range, low above high
[[nodiscard]] Range range_of(const Eigen::Ref<const Eigen::VectorXd>& x);

constexpr Eigen::Index piece_length = 256;

/// Ranges of every `piece_length` samples, the last piece shorter: what lies
/// low as a whole need not be looked at again.
[[nodiscard]] std::vector<Range> piece_ranges(
    const Eigen::Ref<const Eigen::VectorXd>& x);

/// Range of all pieces together.
[[nodiscard]] Range joined(const std::vector<Range>& pieces);

}  // namespace tapfit::acquisition
