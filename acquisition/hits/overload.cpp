#include "acquisition/hits/overload.hpp"

#include "acquisition/samples/range.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Smallest step between different neighbours: the quantisation of a record.
// Looked for no further once it is `enough`: smaller ones make no difference.
double quantisation(const Eigen::Ref<const Eigen::VectorXd>& block,
                    double enough) {
  constexpr double none = std::numeric_limits<double>::max();
  double least = none;
  for (Index i = 1; i < block.size() && least > enough; ++i) {
    const double step = std::abs(block[i] - block[i - 1]);
    if (step > 0.0) least = std::min(least, step);
  }
  return least == none ? 0.0 : least;
}

// Two peaks that have just parted, x = top - (t^2 - a^2)^2, dip between them by
// a^4 = d and lie within d of the top over |t| <= sqrt(2) a; half of that
// further out, at sqrt(8) a, they have fallen by 49 d.
constexpr double least_fall = 49.0;
// In so many standard deviations of noise lie 99.9 % of tops of ten samples.
// Longer ones are found as a pile.
constexpr double range_of_ten = 6.0;

// Whether the run [first, last] of samples near the top falls off like a
// clipped signal does on both sides. `sign` -1 turns the block over.
bool is_flat_top(const Eigen::Ref<const Eigen::VectorXd>& x,
                 double sign,
                 Index first,
                 Index last,
                 double fallen) {
  const Index n = last - first + 1;
  if (n < 3) return false;
  const Index reach = std::max<Index>(1, n / 2);
  const Index left = first - reach;
  const Index right = last + reach;
  if (left < 0 || right >= x.size()) return false;
  return sign * x[left] < fallen && sign * x[right] < fallen;
}

// Whether the signal rests below a level at the block's beginning and end.
// Where it rests it piles up, and is flat between two blows, without being
// clipped.
bool begins_and_ends_below(const Eigen::Ref<const Eigen::VectorXd>& x,
                           double sign,
                           double level) {
  const Index few = std::min<Index>(16, x.size());
  return sign * median(x.head(few)) < level &&
         sign * median(x.tail(few)) < level;
}

// @param top the largest value of sign * x
bool has_flat_top(const Eigen::Ref<const Eigen::VectorXd>& x,
                  const std::vector<Range>& pieces,
                  double sign,
                  double top,
                  double tolerance) {
  const double high = top - tolerance;
  const double fallen = top - least_fall * tolerance;
  if (!begins_and_ends_below(x, sign, high)) return false;
  // Only between samples that have fallen can one lie.
  const auto falls = [&](const Range& piece) {
    return std::min(sign * piece.low, sign * piece.high) < fallen;
  };
  const auto before = std::ranges::find_if(pieces, falls) - pieces.begin();
  const auto after = std::find_if(pieces.rbegin(), pieces.rend(), falls);
  const Index end = std::min(x.size(), piece_length * (pieces.rend() - after));
  for (Index i = piece_length * before; i < end; ++i) {
    const Range& piece = pieces[static_cast<std::size_t>(i / piece_length)];
    if (std::max(sign * piece.low, sign * piece.high) < high) {
      i += piece_length - i % piece_length - 1;
      continue;
    }
    if (sign * x[i] < high) continue;
    const Index first = i;
    while (i + 1 < x.size() && sign * x[i + 1] >= high) ++i;
    if (is_flat_top(x, sign, first, i, fallen)) return true;
  }
  return false;
}

// 1 / (2^(1/4) - 1) and 1 / (4^(1/4) - 1): see the header.
constexpr double near_top = 5.285;
constexpr double farther_from_top = 2.414;
// Half way, as a ratio, from the noise's own to the 2.1 of a merged peak.
constexpr double most_scatter = 1.45;
// Ten times the 14 u, or 28 u, below the top that are looked at.
constexpr double least_swing = 140.0;
constexpr double ample_swing = 280.0;
// A top ends between two samples on either side.
constexpr double ends = 2.0;

// How many samples lie how far below a top, in units of the noise.
struct Below {
  double within_7 = 0.0;
  double within_14 = 0.0;
  double within_28 = 0.0;
  double sum = 0.0;      // of those within 7
  double squares = 0.0;  // of those within 7

  void add(double depth) {
    if (depth > 28.0) return;
    ++within_28;
    if (depth > 14.0) return;
    ++within_14;
    if (depth > 7.0) return;
    ++within_7;
    sum += depth;
    squares += depth * depth;
  }
  [[nodiscard]] double scatter() const {
    const double mean = sum / within_7;
    return std::sqrt(std::max(0.0, squares / within_7 - mean * mean));
  }
};

// The same of most of the time.
bool mostly_below(const Eigen::Ref<const Eigen::VectorXd>& x,
                  double sign,
                  double level) {
  constexpr Index enough = 1 << 10;
  return sign * median(thinned(x, enough)) < level;
}

// @param top the largest value of sign * x
// @param swing of the block, in units of `noise` as all within
bool piles_up(const Eigen::Ref<const Eigen::VectorXd>& x,
              const std::vector<Range>& pieces,
              double sign,
              double top,
              double noise,
              double swing) {
  if (!(swing > least_swing)) return false;
  // First, because it spares most quiet blocks the rest.
  const double rest = top - 0.2 * swing * noise;
  if (!begins_and_ends_below(x, sign, rest)) return false;
  Below below;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Range& piece = pieces[p];
    const double high = std::max(sign * piece.low, sign * piece.high);
    if (top - high > 28.0 * noise) continue;
    const Index from = piece_length * static_cast<Index>(p);
    for (const double value :
         x.segment(from, std::min(piece_length, x.size() - from))) {
      below.add((top - sign * value) / noise);
    }
  }
  if (below.scatter() > most_scatter) return false;
  const double near = below.within_14 - below.within_7 + ends;
  const double far = below.within_28 - below.within_7 + ends;
  if (below.within_7 <= near_top * near &&
      (swing <= ample_swing || below.within_7 <= farther_from_top * far)) {
    return false;
  }
  return mostly_below(x, sign, rest);
}

}  // namespace

bool is_overloaded(const Eigen::Ref<const Eigen::VectorXd>& block,
                   double full_scale,
                   double noise) {
  const std::vector<Range> pieces = piece_ranges(block);
  const auto [low, high] = joined(pieces);
  if (std::max(high, -low) >= 0.999 * full_scale) return true;
  const double swing = high - low;
  const double smooth = std::max(1e-5 * swing, range_of_ten * noise);
  const double tolerance =
      std::max(smooth, 1.5 * quantisation(block, smooth / 1.5));
  const double unit =
      std::max({noise, 1e-5 * swing, quantisation(block, noise)});
  if (piles_up(block, pieces, 1.0, high, unit, swing / unit) ||
      piles_up(block, pieces, -1.0, -low, unit, swing / unit)) {
    return true;
  }
  if (swing < least_fall * tolerance) return false;
  return has_flat_top(block, pieces, 1.0, high, tolerance) ||
         has_flat_top(block, pieces, -1.0, -low, tolerance);
}

}  // namespace tapfit::acquisition
