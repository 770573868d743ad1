#include "signal/ringing.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Columns Re and Im of exp(lambda t) for samples [begin, begin + n), t counted
// from `origin`.
Eigen::MatrixXd decays(const Eigen::VectorXcd& poles,
                       double fs,
                       Index begin,
                       Index n,
                       Index origin) {
  Eigen::MatrixXd A(n, 2 * poles.size());
  for (Index r = 0; r < poles.size(); ++r) {
    const std::complex<double> step = std::exp(poles(r) / fs);
    std::complex<double> value =
        std::exp(poles(r) * (static_cast<double>(begin - origin) / fs));
    for (Index i = 0; i < n; ++i) {
      A(i, 2 * r) = value.real();
      A(i, 2 * r + 1) = value.imag();
      value *= step;
    }
  }
  return A;
}

}  // namespace

Stretch ringing_stretch(const Eigen::VectorXcd& poles,
                        double fs,
                        const Stretch& before) {
  if (poles.size() == 0) return {};
  // Twelve periods of the slowest pole fix its amplitude and phase; more would
  // only ask for more digits of the poles.
  const double slowest = poles.cwiseAbs().minCoeff() / (2.0 * std::numbers::pi);
  const auto wanted = static_cast<Index>(12.0 * fs / slowest);
  const Stretch fit = {std::max(before.begin, before.end - wanted), before.end};
  // Fewer than two periods, or hardly more samples than unknowns: no fit.
  const auto least = std::max<Index>(static_cast<Index>(2.0 * fs / slowest),
                                     4 * (2 * poles.size() + 1));
  return fit.length() >= least ? fit : Stretch{};
}

Eigen::VectorXd ringing(const Eigen::Ref<const Eigen::VectorXd>& channel,
                        const Stretch& fit,
                        const Eigen::VectorXcd& poles,
                        double fs,
                        Index begin,
                        Index n) {
  if (fit.length() == 0 || poles.size() == 0) return Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd A(fit.length(), 2 * poles.size() + 1);
  A.leftCols(2 * poles.size()) =
      decays(poles, fs, fit.begin, fit.length(), fit.end);
  A.rightCols(1).setOnes();
  // Fast poles have vanished at the end of the stretch and are huge at its
  // start; columns of equal length keep the fit well posed.
  const Eigen::VectorXd norms = A.colwise().norm().cwiseMax(1e-300);
  A = (A * norms.cwiseInverse().asDiagonal()).eval();
  Eigen::VectorXd a =
      A.colPivHouseholderQr().solve(channel.segment(fit.begin, fit.length()));
  a = a.cwiseQuotient(norms).eval();
  return decays(poles, fs, begin, n, fit.end) * a.head(2 * poles.size());
}

}  // namespace tapfit::signal
