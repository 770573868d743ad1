#include "acquisition/samples/octave_decay.hpp"

#include "acquisition/samples/anti_alias.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double octave_end = alias_free_fraction;  // of the sampling rate
constexpr Index reach = 24;                         // taps to either side
constexpr Index edge = 16;       // samples that filters before spoil at an end
constexpr Index shortest = 200;  // samples of a response
constexpr Index most_windows = 64;
constexpr Index fewest = 4;          // of them in a line
constexpr double negligible = 1e-3;  // of the loudest

// Passes the octave below 0.3 of the sampling rate: the difference of two
// low-passes, sinc under Blackman's window, which stops by 74 dB.
Eigen::VectorXd octave_taps() {
  Eigen::VectorXd taps(2 * reach + 1);
  const auto low_pass = [](double end, double t) {
    const double x = 2.0 * std::numbers::pi * end * t;
    return t == 0.0 ? 2.0 * end : 2.0 * end * std::sin(x) / x;
  };
  for (Index k = 0; k < taps.size(); ++k) {
    const auto t = static_cast<double>(k - reach);
    const double x = std::numbers::pi * t / (reach + 1.0);
    const double window = 0.42 + 0.5 * std::cos(x) + 0.08 * std::cos(2.0 * x);
    taps(k) =
        window * (low_pass(octave_end, t) - low_pass(0.5 * octave_end, t));
  }
  return taps;
}

/// Levels in windows of equal length.
struct Levels {
  Eigen::VectorXd rms;
  double window = 0.0;  ///< samples
};

Levels octave_levels(const Eigen::VectorXd& x) {
  static const Eigen::VectorXd taps = octave_taps();
  const Index first = edge + reach;
  const Index usable = x.size() - 2 * first;
  const Index window = std::max<Index>(8, usable / most_windows);
  // So many of a window's values tell its level to 1 dB.
  constexpr Index enough = 64;
  const Index stride = std::max<Index>(1, window / enough);
  Levels levels{Eigen::VectorXd::Zero(usable / window),
                static_cast<double>(window)};
  for (Index w = 0; w < levels.rms.size(); ++w) {
    Index count = 0;
    for (Index i = 0; i < window; i += stride, ++count) {
      const Index at = first + w * window + i;
      const double value = taps.dot(x.segment(at - reach, taps.size()));
      levels.rms(w) += value * value;
    }
    levels.rms(w) = std::sqrt(levels.rms(w) / static_cast<double>(count));
  }
  return levels;
}

// The middle of the quietest quarter: the lowest of many levels of noise lies
// far below what is usual.
double quiet_level(const Eigen::VectorXd& rms) {
  std::vector<double> levels(rms.begin(), rms.end());
  const auto low = levels.begin() + std::ssize(levels) / 8;
  std::nth_element(levels.begin(), low, levels.end());
  return *low;
}

// Decay per window of the last 20 dB over the quietest, or over what is 60 dB
// below the loudest.
std::optional<double> decay_of(const Eigen::VectorXd& rms) {
  constexpr double clear = 3.0;     // of the quietest, 10 dB
  constexpr double span = 30.0;     // ... and 20 dB more
  constexpr double fall = 0.7;      // 6 dB
  constexpr double straight = 0.3;  // 2.6 dB
  Index loudest = 0;
  rms.maxCoeff(&loudest);
  const double quiet =
      std::max(quiet_level(rms), negligible * rms(loudest) / clear);
  if (!(quiet > 0.0)) return std::nullopt;
  Index end = loudest;
  while (end < rms.size() && rms(end) > clear * quiet) ++end;
  Index begin = loudest;
  while (begin < end && rms(begin) > span * quiet) ++begin;
  begin = std::max(loudest, std::min(begin, end - fewest));
  const Index count = end - begin;
  if (count < fewest) return std::nullopt;
  const Eigen::VectorXd level = rms.segment(begin, count).array().log();
  const double half = 0.5 * static_cast<double>(count - 1);
  const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(count, -half, half);
  const double slope = t.dot(level) / t.squaredNorm();
  const double off =
      ((level.array() - level.mean()) - slope * t.array()).matrix().norm() /
      std::sqrt(static_cast<double>(count));
  if (-slope * 2.0 * half < fall || off > straight) return std::nullopt;
  return -slope;
}

/// What is heard in one octave.
struct Octave {
  std::array<double, 2> hz = {};
  Eigen::VectorXd rms;
  double window_s = 0.0;
};

std::vector<Octave> octaves_of(const Eigen::VectorXd& response,
                               double rate,
                               const std::array<double, 2>& band_hz) {
  // Down to the band's upper end in one step.
  int above = 1;
  while (0.5 * octave_end * rate / above >= band_hz[1] &&
         response.size() / above > shortest) {
    above *= 2;
  }
  rate /= above;
  std::vector<Octave> octaves;
  Eigen::VectorXd x =
      above > 1 ? Eigen::VectorXd(decimate(response, above)) : response;
  for (; x.size() >= shortest && octave_end * rate >= band_hz[0]; rate *= 0.5) {
    Levels levels = octave_levels(x);
    octaves.push_back({{0.5 * octave_end * rate, octave_end * rate},
                       std::move(levels.rms),
                       levels.window / rate});
    x = decimate(x, 2);
  }
  return octaves;
}

}  // namespace

std::optional<OctaveDecay> slowest_decay(const Eigen::VectorXd& response,
                                         double sample_rate_hz,
                                         const std::array<double, 2>& band_hz) {
  const std::vector<Octave> octaves =
      octaves_of(response, sample_rate_hz, band_hz);
  double loudest = 0.0;
  for (const Octave& octave : octaves) {
    loudest = std::max(loudest, octave.rms.maxCoeff());
  }
  std::optional<OctaveDecay> slowest;
  for (const Octave& octave : octaves) {
    // As little as that may have come through the filters.
    if (octave.rms.maxCoeff() < negligible * loudest) continue;
    const std::optional<double> decay = decay_of(octave.rms);
    if (!decay) continue;
    const double rate = *decay / octave.window_s;
    if (!slowest || rate < slowest->rate) slowest = {rate, octave.hz};
  }
  return slowest;
}

}  // namespace tapfit::acquisition
