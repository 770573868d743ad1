#include "signal/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::signal {
namespace {

std::complex<double> ratio(double Gff,
                           double Gyy,
                           std::complex<double> Gyf,
                           Estimator estimator) {
  if (!(Gff > 0.0) || !(std::abs(Gyf) > 0.0)) return 0.0;
  switch (estimator) {
    case Estimator::H1:
      return Gyf / Gff;
    case Estimator::H2:
      return Gyy / std::conj(Gyf);
    case Estimator::Hv:
      return std::sqrt(Gyy / Gff) * (Gyf / std::abs(Gyf));
  }
  return 0.0;
}

}  // namespace

Estimate estimate(const Eigen::MatrixXcd& force,
                  const Eigen::MatrixXcd& response,
                  Estimator estimator) {
  const Eigen::Index lines = force.rows();
  Estimate result{Eigen::VectorXcd(lines), Eigen::VectorXd::Ones(lines)};
  for (Eigen::Index i = 0; i < lines; ++i) {
    const double Gff = force.row(i).squaredNorm();
    const double Gyy = response.row(i).squaredNorm();
    // dot() conjugates its left side: sum conj(F) Y.
    const std::complex<double> Gyf = force.row(i).dot(response.row(i));
    result.H(i) = ratio(Gff, Gyy, Gyf, estimator);
    if (force.cols() > 1)
      result.coherence(i) = Gff > 0.0 && Gyy > 0.0
                                ? std::min(1.0, std::norm(Gyf) / Gff / Gyy)
                                : 0.0;
  }
  return result;
}

}  // namespace tapfit::signal
