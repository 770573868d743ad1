// How far |H| and damping ratios of an estimate are from those of the modes
// that made the record. For tests and the study over random modes.
#pragma once

#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_test.hpp"

#include <Eigen/QR>

namespace tapfit::signal {

// |H| of the modes one by one: near antiresonances they cancel, and what is
// left has no scale of its own.
inline double sum_of_sizes(const std::vector<TestMode>& modes,
                           std::complex<double> s) {
  double sum = 0.0;
  for (const TestMode& mode : modes) sum += std::abs(exact_frf({mode}, s));
  return sum;
}

// @param modes by frequency
inline double worst_scale_error(const FrfSet& set,
                                const std::vector<TestMode>& modes) {
  const Eigen::VectorXd f = set.frequency_hz();
  double worst = 0.0;
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    // Below the lowest resonance what the block's end cuts off counts more, by
    // the square of frequency: 0.7 % at 0.6 of it.
    if (f(i) < 0.9 * modes.front().hz || f(i) > 1.066 * modes.back().hz) {
      continue;
    }
    const std::complex<double> exact = exact_frf(modes, set.s(i));
    if (std::abs(exact) < 0.5 * sum_of_sizes(modes, set.s(i))) continue;
    const double ratio = std::abs(set.frfs[0].H(i)) / std::abs(exact);
    worst = std::max(worst, std::abs(ratio - 1.0));
  }
  return worst;
}

// Damping ratio of the pole near f0, by least squares over the nearest lines of
//   H (s^2 + c1 s + c0) = b2 s^2 + b1 s + b0
// (s in units of 2 pi f0).
inline double damping_near(const FrfSet& set, double f0) {
  const Eigen::VectorXd f = set.frequency_hz();
  Eigen::Index middle = 0;
  (f.array() - f0).abs().minCoeff(&middle);
  constexpr Eigen::Index reach = 12;
  const Eigen::Index n = 2 * reach + 1;
  Eigen::MatrixXd A(2 * n, 5);
  Eigen::VectorXd b(2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index i = middle - reach + k;
    const std::complex<double> s = set.s(i) / (2.0 * std::numbers::pi * f0);
    const std::complex<double> H = set.frfs[0].H(i);
    const std::complex<double> row[] = {H * s, H, -s * s, -s, -1.0};
    for (Eigen::Index c = 0; c < 5; ++c) {
      A(k, c) = row[c].real();
      A(n + k, c) = row[c].imag();
    }
    b(k) = (-H * s * s).real();
    b(n + k) = (-H * s * s).imag();
  }
  const Eigen::VectorXd x = A.colPivHouseholderQr().solve(b);
  return x(0) / (2.0 * std::sqrt(x(1)));
}

struct Worst {
  double scale = 0.0;
  double damping = 0.0;
};

inline Worst worst_of(const GeneratedTest& test,
                      const std::vector<TestMode>& modes,
                      const FrfOptions& options) {
  const FrfSet set =
      estimate_frfs(test.bundle, test.recordings, test.hits, options);
  Worst worst{worst_scale_error(set, modes), 0.0};
  for (const TestMode& mode : modes) {
    const double bias = damping_near(set, mode.hz) / mode.zeta - 1.0;
    worst.damping = std::max(worst.damping, std::abs(bias));
  }
  return worst;
}

}  // namespace tapfit::signal
