#include "signal/level_course.hpp"

#include "acquisition/choose_block.hpp"
#include "signal/fft.hpp"
#include "signal/offset.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

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

/// The line y = start + slope k through the first values.
struct Straight {
  double start = 0.0;
  double slope = 0.0;
  [[nodiscard]] double at(Index k) const {
    return start + slope * static_cast<double>(k);
  }
};

Straight through(const Eigen::Ref<const Eigen::VectorXd>& y) {
  const double last = static_cast<double>(y.size() - 1);
  const Eigen::VectorXd x =
      Eigen::VectorXd::LinSpaced(y.size(), -0.5 * last, 0.5 * last);
  const double slope = x.dot(y) / x.squaredNorm();
  return {y.mean() - 0.5 * last * slope, slope};
}

// Segments that the fall lasts: up to where two in a row lie above it. One that
// does, or lies below, is what the ambient response adds or takes off.
Index falling(const Eigen::VectorXd& level) {
  constexpr double above = 0.23;  // 2 dB
  Index count = 3;
  while (count < level.size()) {
    const Straight fall = through(level.head(count));
    const Index second = std::min(count + 1, level.size() - 1);
    if (level(count) > fall.at(count) + above &&
        level(second) > fall.at(second) + above) {
      break;
    }
    ++count;
  }
  return count;
}

std::optional<Fall> fall_of(const Eigen::VectorXd& level,
                            double hop_s,
                            double segment_s) {
  constexpr double clear = 0.7;     // 6 dB
  constexpr double straight = 0.3;  // 2.6 dB
  const Index count = falling(level);
  const Straight fall = through(level.head(count));
  if (fall.at(0) - fall.at(count - 1) < clear) return std::nullopt;
  double square = 0.0;
  for (Index k = 0; k < count; ++k) {
    square += std::pow(level(k) - fall.at(k), 2);
  }
  if (square > straight * straight * static_cast<double>(count)) {
    return std::nullopt;
  }
  return Fall{-fall.slope / hop_s,
              static_cast<double>(count - 1) * hop_s + 0.5 * segment_s};
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

LevelCourse Segments::course(double hz, double noise) const {
  LevelCourse course;
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
  course.fall = fall_of(level, static_cast<double>(hop_) * dt_, segment_s);
  return course;
}

}  // namespace tapfit::signal
