#include "signal/spectra/decays.hpp"

#include <Eigen/QR>

#include <cmath>
#include <complex>

namespace tapfit::signal {

using Eigen::Index;

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

Eigen::MatrixXd fit_decays(const Eigen::MatrixXd& decays,
                           const Eigen::Ref<const Eigen::MatrixXd>& x) {
  Eigen::MatrixXd A(decays.rows(), decays.cols() + 1);
  A.leftCols(decays.cols()) = decays;
  A.rightCols(1).setOnes();
  const Eigen::VectorXd norms = A.colwise().norm().cwiseMax(1e-300);
  A *= norms.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd a =
      norms.cwiseInverse().asDiagonal() * A.colPivHouseholderQr().solve(x);
  return a.topRows(decays.cols());
}

}  // namespace tapfit::signal
