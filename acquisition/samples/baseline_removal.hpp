// A channel seen without its DC and slow drift, and turned over if need be.
//
// Nothing is copied: a record takes as much memory as anything here, and most
// of it is never looked at again once its pieces' ranges are known.
#pragma once

#include "acquisition/samples/range.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tapfit::acquisition {

/// value(i) = sign (channel(i) - drift(i)), the drift being the medians of
/// segments, joined by straight lines. A segment's median is taken from 512 of
/// its samples at most; it is then known to 6 % of the noise.
///
/// A median does not see a hammer's pulse, which fills far less than half of
/// a segment; a response that rings at more than a few times 1/segment has a
/// median near its mean.
///
/// The channel must outlive it.
class BaselineFree {
 public:
  BaselineFree() = default;

  /// The values as they are.
  BaselineFree(const Eigen::VectorXd& values);  // NOLINT: a view of themselves

  /// @param segment samples per segment, > 0
  BaselineFree(const Eigen::Ref<const Eigen::VectorXd>& channel,
               Eigen::Index segment);

  /// Changes the sign.
  void turn() { sign_ = -sign_; }

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] double operator[](Eigen::Index i) const;

  /// @param first, count within the channel
  [[nodiscard]] Eigen::VectorXd segment(Eigen::Index first,
                                        Eigen::Index count) const;

  /// At most `most` of the values, as thinned() takes them.
  [[nodiscard]] Eigen::VectorXd thinned(Eigen::Index most) const;

  /// Bounds of every `piece_length` values: the channel's own ranges less what
  /// the drift is at the piece's ends, too wide by no more than it changes from
  /// one end to the other.
  [[nodiscard]] std::vector<Range> pieces() const;

 private:
  /// Straight from one segment's middle to the next one's, level before the
  /// first and after the last.
  struct Line {
    double start = 0.0;    ///< at sample 0, were it as long
    double slope = 0.0;    ///< per sample
    Eigen::Index end = 0;  ///< the first sample behind it
  };
  [[nodiscard]] static double drift_on(const Line& line, Eigen::Index i);
  [[nodiscard]] std::size_t line_at(Eigen::Index i) const;
  void copy(Eigen::Index first, Eigen::Ref<Eigen::VectorXd> out) const;

  const double* samples_ = nullptr;
  Eigen::Index size_ = 0;
  double length_ = 0.0;  ///< of a segment [samples]
  std::vector<Line> lines_;
  double sign_ = 1.0;
};

}  // namespace tapfit::acquisition
