#include "updating/frf_model/modal_derivatives.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::complex;

namespace {

// Below this share of s^2 and lambda the difference of two modes' answers,
// over that of their lambda, loses half of its digits.
constexpr double too_close = 1e-7;
// Modes of one frequency have no direction of their own that damping goes with.
constexpr double same = 1e-9;

MatrixXd in_modes(const MatrixXd& phi, const MatrixXd& of_base) {
  if (of_base.size() == 0) return MatrixXd::Zero(phi.cols(), phi.cols());
  return phi.transpose() * (of_base * phi);
}

}  // namespace

ModalDerivative::ModalDerivative(const MatrixXd& phi,
                                 const VectorXd& omega,
                                 const DampingOfModes& damping,
                                 const MatrixXd& dK,
                                 const MatrixXd& dM,
                                 double largest)
    : A_(in_modes(phi, dM)) {
  const MatrixXd k = in_modes(phi, dK);
  const VectorXd l = omega.cwiseAbs2();
  const VectorXd& d = damping.d;
  const VectorXd of_mass = A_.diagonal();
  lambda_ = k.diagonal() - l.cwiseProduct(of_mass);
  d_ = damping.slope.cwiseProduct(lambda_);
  for (Index j = 0; j < l.size(); ++j) {
    for (Index i = 0; i < j; ++i) {
      const double m = A_(i, j);
      const double apart = l(j) - l(i);
      if (std::abs(apart) >
          too_close * std::max({l(i), l(j), largest * largest})) {
        A_(i, j) = (k(i, j) - l(j) * m) / apart;
        A_(j, i) = (l(i) * m - k(i, j)) / apart;
        continue;
      }
      A_(i, j) = A_(j, i) = 0.0;
      const bool one = std::abs(apart) <= same * std::max(l(i), l(j));
      const double c =
          one ? 0.0
              : (k(i, j) * (d(j) - d(i)) + m * (l(j) * d(i) - l(i) * d(j))) /
                    apart;
      close_.push_back({i, j, k(i, j), c, m});
    }
  }
  A_.diagonal() = -0.5 * of_mass;
}

void ModalDerivative::take_close(complex<double> s,
                                 const MatrixXcd& Xo,
                                 const MatrixXcd& Xi,
                                 MatrixXcd& change) const {
  for (const Close& p : close_) {
    const complex<double> z = p.k + s * (p.c + s * p.m);
    change.noalias() -= z * Xo.row(p.i).transpose() * Xi.row(p.j);
    change.noalias() -= z * Xo.row(p.j).transpose() * Xi.row(p.i);
  }
}

}  // namespace tapfit::updating
