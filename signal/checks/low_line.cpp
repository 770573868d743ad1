#include "signal/checks/low_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Root mean square that the two terms may miss the lines by, noise apart, and
// the share of the second that still leaves the first to be told.
constexpr double most_missed = 0.05;
constexpr double most_bent = 0.5;

// a of y = a + b x, each line divided by |y|; empty where that is not what y
// is.
std::optional<double> at_zero(const Eigen::ArrayXcd& y,
                              const Eigen::ArrayXcd& x,
                              double noise) {
  const Eigen::ArrayXd w = y.abs2().max(1e-300).inverse();
  const double ww = w.sum();
  const double wx = (w * x.real()).sum();
  const double xx = (w * x.abs2()).sum();
  const double wy = (w * y.real()).sum();
  const double xy = (w * (x.conjugate() * y).real()).sum();
  const double determinant = ww * xx - wx * wx;
  if (!(determinant > 0.0)) return std::nullopt;
  const double a = (xx * wy - wx * xy) / determinant;
  const double b = (ww * xy - wx * wy) / determinant;
  const double missed = (w * (y - a - b * x).abs2()).mean();
  const double bent = std::abs(b) * x.abs().maxCoeff();
  const bool fits = missed <= most_missed * most_missed + 2.0 * noise;
  return fits && bent <= most_bent * std::abs(a) ? std::optional(a)
                                                 : std::nullopt;
}

}  // namespace

LowLines low_lines(const Eigen::VectorXcd& s, const Frf& frf) {
  Index n = 0;
  while (n < s.size() && s(n).imag() <= 2.0 * s(0).imag()) ++n;
  if (n < 4 || !(s(0).imag() > 0.0)) return {};
  const Eigen::ArrayXcd A = frf.H.head(n).array();
  const Eigen::ArrayXcd s2 = s.head(n).array().square();
  // Of the scatter over hits, as far as it is known.
  const double noise =
      frf.variance.size() < n
          ? 0.0
          : std::min(
                0.25,
                (frf.variance.head(n).array() / A.abs2().max(1e-300)).mean());
  if (const auto a = at_zero(A, s2, noise)) return {LowLine::Mass, 1.0 / *a};
  if (const auto a = at_zero(A / s2, s2, noise)) {
    return {LowLine::Stiffness, 1.0 / *a};
  }
  return {};
}

}  // namespace tapfit::signal
