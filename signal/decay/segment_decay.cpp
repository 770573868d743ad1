#include "signal/decay/segment_decay.hpp"

#include "acquisition/hits/choose_block.hpp"
#include "acquisition/samples/statistics.hpp"
#include "signal/spectra/fft.hpp"
#include "signal/spectra/offset.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::signal {
namespace {

using Eigen::Index;

constexpr Index parts = 8;
constexpr Index fewest = 11;    // segments
constexpr Index shortest = 16;  // samples of a segment
constexpr Index lowest = 2;     // line; below, the mirror image is near
constexpr Index order = 3;      // decays at one line
// Of the level, what decays may leave. They leave next to nothing; the ambient
// response of a mode 0.3 and more.
constexpr double unexplained = 0.1;
constexpr double noise_weight = 5.0;

// What is left of z where each is predicted from the `order` before it, of the
// level there; noise counts as level.
double left_over(const Eigen::VectorXcd& z, double noise_rms) {
  const Index rows = z.size() - order;
  Eigen::MatrixXcd before(rows, order);
  Eigen::VectorXcd now(rows);
  for (Index k = 0; k < rows; ++k) {
    const double level =
        std::max({z.segment(k, order + 1).cwiseAbs().maxCoeff(),
                  noise_weight * noise_rms,
                  1e-300});
    before.row(k) = z.segment(k, order).transpose() / level;
    now(k) = z(k + order) / level;
  }
  const Eigen::VectorXcd a = before.colPivHouseholderQr().solve(now);
  return (before * a - now).norm() / std::sqrt(static_cast<double>(rows));
}

/// The autoregression z_k = q z_{k-1} + e_k.
struct Regression {
  double q = 1.0;        ///< magnitude
  double sd = 0.0;       ///< of it
  double floor = 0.0;    ///< mean power of what the e_k alone leave
  Eigen::ArrayXd left;   ///< |e_k|^2, per step
  Index first_blow = 0;  ///< first step that is no chance; none: past the end
};

// Least squares over the steps that are kept.
Regression regression(const Eigen::VectorXcd& z, const Eigen::ArrayXd& kept) {
  const Index steps = z.size() - 1;
  const Eigen::ArrayXcd before = z.head(steps).array();
  const Eigen::ArrayXcd now = z.tail(steps).array();
  const double power = std::max((kept * before.abs2()).sum(), 1e-300);
  const std::complex<double> q =
      (kept * (now * before.conjugate())).sum() / power;
  Regression found;
  found.left = (now - q * before).abs2();
  const double variance =
      (kept * found.left).sum() / std::max(kept.sum() - 1.0, 1.0);
  found.q = std::abs(q);
  found.sd = std::sqrt(0.5 * variance / power);
  found.floor = variance / std::max(1.0 - found.q * found.q, 1e-12);
  return found;
}

// A step of so many times the median's power is no chance: an exponential
// distribution goes as far once in 60,000 steps.
constexpr double no_chance = 16.0;

Regression robust_regression(const Eigen::VectorXcd& z) {
  Eigen::ArrayXd kept = Eigen::ArrayXd::Ones(z.size() - 1);
  Regression found = regression(z, kept);
  constexpr int passes = 5;
  for (int pass = 0; pass < passes; ++pass) {
    // Rounding is no blow.
    const double limit = no_chance * acquisition::median(found.left.matrix()) +
                         1e-12 * z.cwiseAbs2().maxCoeff();
    kept = (found.left <= limit).cast<double>();
    found = regression(z, kept);
  }
  found.first_blow = kept.size();
  for (Index k = kept.size() - 1; k >= 0; --k) {
    if (kept(k) == 0.0) found.first_blow = k;
  }
  return found;
}

std::optional<DecayEstimate> fall_of(const Eigen::VectorXcd& z,
                                     double hop_s,
                                     double segment_s) {
  constexpr double clear = 1.4;  // ln of the power's ratio, 6 dB
  const Regression found = robust_regression(z);
  if (!(found.q + 2.0 * found.sd < 1.0) || !(found.q > 0.0)) {
    return std::nullopt;
  }
  const double decay = -std::log(found.q);  // from segment to segment
  const double above =
      std::log(std::norm(z(0)) / std::max(found.floor, 1e-300));
  const double end = std::clamp(
      0.5 * above / decay, 0.0, static_cast<double>(found.first_blow));
  if (2.0 * decay * end < clear) return std::nullopt;
  const double least_q = std::max(found.q - 2.0 * found.sd, 1e-12);
  return DecayEstimate{
      decay / hop_s, -std::log(least_q) / hop_s, end * hop_s + 0.5 * segment_s};
}

}  // namespace

Segments::Segments(const Eigen::Ref<const Eigen::VectorXd>& response, double dt)
    : dt_(dt),
      length_(response.size() < parts * shortest
                  ? 0
                  : acquisition::smooth_length(response.size() / parts)),
      hop_(length_ / 2) {
  if (length_ == 0) return;
  const Index count = (response.size() - length_) / hop_ + 1;
  const Eigen::VectorXd window = hann(length_);
  window_power_ = window.squaredNorm();
  lines_.resize(length_ / 2 + 1, count);
  RealFft fft(length_);
  for (Index k = 0; k < count; ++k) {
    fft.transform(
        response.segment(k * hop_, length_), window, 0, lines_.col(k));
  }
}

SegmentDecay Segments::course(double hz, double noise) const {
  SegmentDecay course;
  const double segment_s = static_cast<double>(length_) * dt_;
  const auto line = static_cast<Index>(std::lround(hz * segment_s));
  if (lines_.cols() < fewest || line < lowest || line >= lines_.rows()) {
    return course;
  }
  const Eigen::VectorXcd z = lines_.row(line).transpose();
  course.decays = left_over(z, std::sqrt(noise * window_power_)) < unexplained;
  const Eigen::VectorXd level = z.cwiseAbs().cwiseMax(1e-300).array().log();
  constexpr double two_db = 0.23;
  const double spread = (level.array() - level.mean()).matrix().norm() /
                        std::sqrt(static_cast<double>(level.size()));
  course.steady = spread < two_db;
  course.fall = fall_of(z, static_cast<double>(hop_) * dt_, segment_s);
  return course;
}

}  // namespace tapfit::signal
