#include "modal/fit/fit_noise.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/linear_fit.hpp"
#include "modal/poles/fit_columns.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// Lines of one FRF whose |H|^2 is alike.
struct Level {
  double power = 0.0;  // mean |H|^2
  double left = 0.0;   // mean |e|^2 without what the fit follows
  double lines = 0.0;
};

std::vector<Level> levels_of(const Eigen::VectorXd& followed,
                             const Eigen::VectorXd& left,
                             const Eigen::VectorXd& power) {
  constexpr double octaves = 2.0;  // levels of |H|^2 in one
  constexpr double told = 0.3;     // a line followed further tells nothing
  std::map<int, Level> levels;
  for (Index k = 0; k < left.size(); ++k) {
    const double free = 1.0 - followed(k);
    if (free < told || !(power(k) > 0.0)) continue;
    Level& level =
        levels[static_cast<int>(std::floor(octaves * std::log2(power(k))))];
    level.power += power(k);
    level.left += left(k) / free;
    level.lines += 1.0;
  }
  std::vector<Level> result;
  for (auto& [at, level] : levels) {
    level.power /= level.lines;
    level.left /= level.lines;
    result.push_back(level);
  }
  return result;
}

// b of the variance a + b |H|^2 of one FRF, of greatest likelihood for |e|^2,
// which is exponentially distributed. Zero where it could be chance.
double proportional_noise(const std::vector<Level>& levels,
                          double lines_correlated) {
  constexpr int steps = 50;       // of a fixed point that settles in a few
  constexpr double surely = 3.0;  // standard deviations
  double a = 0.0;
  double b = 0.0;
  double precision = 0.0;
  for (int step = 0; step < steps; ++step) {
    // Weighted line of |e|^2 over |H|^2 with the weights of the last step.
    double w = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const Level& level : levels) {
      const double variance = step == 0 ? level.left : a + b * level.power;
      const double weight = level.lines / std::max(variance * variance, 1e-300);
      w += weight;
      x += weight * level.power;
      y += weight * level.left;
      xx += weight * level.power * level.power;
      xy += weight * level.power * level.left;
    }
    if (!(w > 0.0)) return 0.0;
    precision = xx - x * x / w;
    if (!(precision > 0.0)) return 0.0;
    b = std::max(0.0, (xy - x * y / w) / precision);
    a = std::max(0.0, (y - b * x) / w);
  }
  return b * std::sqrt(precision / lines_correlated) > surely ? b : 0.0;
}

// What the FRFs have in common of it, such as blows that scatter leave: the
// middle one's, so that one FRF without a signal says nothing of the others.
//
// Lines at a resonance too sharp for its neighbours to tell of its noise have
// it from all others.
double common_proportion(const Eigen::VectorXd& followed,
                         const Eigen::MatrixXd& left,
                         const Eigen::MatrixXd& power,
                         double lines_correlated) {
  std::vector<double> shares(static_cast<std::size_t>(left.cols()));
  const auto operations = 30.0 * static_cast<double>(left.size());
  for_each_parallel(shares.size(), operations, [&](std::size_t k) {
    const auto f = static_cast<Index>(k);
    shares[k] = proportional_noise(
        levels_of(followed, left.col(f), power.col(f)), lines_correlated);
  });
  if (shares.empty()) return 0.0;
  const auto middle =
      shares.begin() + static_cast<std::ptrdiff_t>((shares.size() - 1) / 2);
  std::nth_element(shares.begin(), middle, shares.end());
  return *middle;
}

/// x with every line's neighbours added as they are correlated.
Eigen::MatrixXcd correlate(const Eigen::MatrixXcd& x, double ratio) {
  constexpr Index reach = 24;
  Eigen::MatrixXcd result = x;
  for (Index d = 1; d <= std::min(reach, x.rows() - 1); ++d) {
    const Complex rho =
        1.0 /
        (1.0 + Complex(0.0, 1.0) * static_cast<double>(d) / (2.0 * ratio));
    const Index n = x.rows() - d;
    result.bottomRows(n) += rho * x.topRows(n);
    result.topRows(n) += std::conj(rho) * x.bottomRows(n);
  }
  return result;
}

/// Share of each line's noise that the residues and terms follow: the mean of
/// its two rows' squares in Q.
Eigen::VectorXd leverage(const WeightedFrfs& curves, const ModalFit& fit) {
  const LinearFit linear = fit_linear(curves, fit.poles);
  return 0.5 * unstack(orthonormal_columns(curves, fit.poles, linear))
                   .rowwise()
                   .squaredNorm();
}

/// Mean over a line and five on each side, fewer at the ends.
Eigen::VectorXd mean_over_lines(const Eigen::VectorXd& x) {
  constexpr Index reach = 5;
  Eigen::VectorXd result(x.size());
  for (Index k = 0; k < x.size(); ++k) {
    const Index begin = std::max<Index>(0, k - reach);
    const Index end = std::min(x.size(), k + reach + 1);
    result(k) = x.segment(begin, end - begin).mean();
  }
  return result;
}

/// E|e|^2 of each value as the few lines around it tell: n_lines x n_frfs.
Eigen::MatrixXd power_near(const WeightedFrfs& curves,
                           const Eigen::MatrixXd& left) {
  Eigen::MatrixXd power(left.rows(), left.cols());
  const auto operations = 30.0 * static_cast<double>(left.size());
  for_each_parallel(
      static_cast<std::size_t>(left.cols()), operations, [&](std::size_t k) {
        const auto f = static_cast<Index>(k);
        power.col(f) = mean_over_lines(left.col(f))
                           .cwiseMax(mean_over_lines(curves.variance.col(f)));
      });
  return power;
}

}  // namespace

Eigen::MatrixXd correlated_gram(const Eigen::MatrixXcd& x, double ratio) {
  const Eigen::MatrixXd own = stack(x);
  if (ratio <= 0.0) return 0.5 * own.transpose() * own;
  return 0.5 * own.transpose() * stack(correlate(x, ratio));
}

Noise weighted_noise(const WeightedFrfs& curves,
                     const ModalFit& fit,
                     NoiseFrom from) {
  Eigen::MatrixXd left;
  Eigen::MatrixXd fitted;
  {
    const Eigen::MatrixXcd H = fitted_accelerance(curves, fit);
    left = (curves.H - H).cwiseAbs2();
    if (from == NoiseFrom::AllLines) fitted = H.cwiseAbs2();
  }
  Eigen::MatrixXd power = power_near(curves, left);
  if (from == NoiseFrom::AllLines) {
    const double shared =
        std::max(1.0, 2.0 * std::numbers::pi * curves.sigma / curves.spacing);
    power = power.cwiseMax(
        common_proportion(leverage(curves, fit), left, fitted, shared) *
        fitted);
  }
  const auto& [v, u] = curves.weights;
  power.array().colwise() *= v.array().square();
  power.array().rowwise() *= u.array().square().transpose();
  Noise noise;
  noise.per_line = power.rowwise().mean().cwiseSqrt();
  noise.power = std::move(power);
  return noise;
}

Eigen::MatrixXd noise_at_modes(const Noise& noise, const Eigen::MatrixXcd& X) {
  const Index modes = X.cols() / 2;
  Eigen::MatrixXd told(X.rows(), modes);
  for (Index r = 0; r < modes; ++r) {
    told.col(r) = X.middleCols(2 * r, 2).rowwise().squaredNorm();
    told.col(r) /= std::max(told.col(r).sum(), 1e-300);
  }
  told =
      noise.per_line.cwiseAbs2().cwiseMax(1e-300).cwiseInverse().asDiagonal() *
      told;
  return (noise.power.transpose() * told).cwiseSqrt();
}

}  // namespace tapfit::modal
