#include "modal/poles/band_circle.hpp"

#include "signal/spectra/fft.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// The next length that FFTs of small primes are fast for.
Index smooth_length(Index least) {
  for (Index n = least;; ++n) {
    Index rest = n;
    for (const Index prime : {2, 3, 5, 7}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return n;
  }
}

}  // namespace

BandCircle lay_on_circle(const WeightedFrfs& curves, Index largest) {
  const double low = curves.s(0).imag();
  const double width = curves.s(curves.lines() - 1).imag() - low;
  const double margin =
      width * std::min(0.05, 1.5 / static_cast<double>(largest));
  BandCircle circle;
  // A band that reaches down to zero has its true conjugate symmetry there.
  circle.omega_0 = low < 1.5 * margin ? 0.0 : low - margin;
  const double half = low + width + margin - circle.omega_0;
  circle.length =
      smooth_length(static_cast<Index>(std::ceil(2.0 * half / curves.spacing)));
  circle.dt = 2.0 * std::numbers::pi /
              (static_cast<double>(circle.length) * curves.spacing);
  circle.first = (low - circle.omega_0) * circle.dt;
  return circle;
}

Eigen::MatrixXd lag_sums(const BandCircle& circle,
                         const Eigen::MatrixXcd& x,
                         Index largest) {
  signal::RealFft fft(circle.length);
  Eigen::VectorXcd turn(largest + 1);
  for (Index l = 0; l <= largest; ++l) {
    turn(l) = std::polar(1.0, -circle.first * static_cast<double>(l));
  }
  Eigen::MatrixXd result(2 * largest + 1, x.cols());
  for (Index c = 0; c < x.cols(); ++c) {
    const Eigen::VectorXcd re = fft.transform(x.col(c).real());
    const Eigen::VectorXcd im = fft.transform(x.col(c).imag());
    for (Index l = 0; l <= largest; ++l) {
      const Complex a = re(l) * turn(l);
      const Complex b = im(l) * turn(l);
      result(largest + l, c) = a.real() - b.imag();
      result(largest - l, c) = a.real() + b.imag();
    }
  }
  return result;
}

}  // namespace tapfit::modal
