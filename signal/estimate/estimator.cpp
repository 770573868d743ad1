#include "signal/estimate/estimator.hpp"

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

CrossPowers& CrossPowers::operator+=(const CrossPowers& other) {
  if (hits == 0) return *this = other;
  hits += other.hits;
  Gff += other.Gff;
  Gyy += other.Gyy;
  Gyf += other.Gyf;
  return *this;
}

CrossPowers cross_powers(const Eigen::MatrixXcd& force,
                         const Eigen::MatrixXcd& response) {
  return {force.cols(),
          force.rowwise().squaredNorm(),
          response.rowwise().squaredNorm(),
          response.cwiseProduct(force.conjugate()).rowwise().sum()};
}

Estimate estimate(const CrossPowers& powers, Estimator estimator) {
  const Eigen::Index lines = powers.Gff.size();
  Estimate result{Eigen::VectorXcd(lines), Eigen::VectorXd::Ones(lines)};
  for (Eigen::Index i = 0; i < lines; ++i) {
    const double Gff = powers.Gff(i);
    const double Gyy = powers.Gyy(i);
    result.H(i) = ratio(Gff, Gyy, powers.Gyf(i), estimator);
    if (powers.hits > 1)
      result.coherence(i) =
          Gff > 0.0 && Gyy > 0.0
              ? std::min(1.0, std::norm(powers.Gyf(i)) / Gff / Gyy)
              : 0.0;
  }
  return result;
}

}  // namespace tapfit::signal
