// H of a small system whose matrices depend on a parameter f, by the modes and
// by solving it.
#include "updating/frf_model/modal_derivatives.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

MatrixXd symmetric(Index n, unsigned seed) {
  std::srand(seed);
  const MatrixXd A = MatrixXd::Random(n, n);
  return A + A.transpose();
}

// s^2 + d s + lambda of each mode.
VectorXcd own_stiffness(const VectorXd& omega,
                        const VectorXd& d,
                        complex<double> s) {
  const VectorXcd l = omega.cwiseAbs2();
  return (l + s * d).array() + s * s;
}

MatrixXcd by_turning(const ModalDerivative& turn,
                     const VectorXcd& z,
                     const MatrixXd& R,
                     complex<double> s) {
  const MatrixXcd X = z.cwiseInverse().asDiagonal() * R;
  const MatrixXcd Y = turn.turned(R).cast<complex<double>>();
  const VectorXcd stiffened = turn.stiffness() + s * turn.damping();
  MatrixXcd change = Y.transpose() * X + X.transpose() * Y -
                     X.transpose() * stiffened.asDiagonal() * X;
  turn.take_close(s, X, X, change);
  return change;
}

TEST(ModalDerivative, IsExactWhereModesHaveOneFrequency) {
  const Index n = 6;
  // Two rigid, two of one frequency, two all but so.
  VectorXd omega(n);
  omega << 0.0, 0.0, 3.0, 3.0, 7.0, 7.0 * (1.0 + 1e-8);
  const MatrixXd dK = symmetric(n, 1);
  const MatrixXd dM = symmetric(n, 2);
  const MatrixXd R = symmetric(n, 3).leftCols(3);
  const VectorXd none = VectorXd::Zero(n);
  const ModalDerivative turn(
      MatrixXd::Identity(n, n), omega, {none, none}, dK, dM, 8.0);
  for (const complex<double> s :
       {complex<double>(0.1, 2.0), complex<double>(0.2, 7.5)}) {
    const VectorXcd z = own_stiffness(omega, none, s);
    const MatrixXcd X = z.cwiseInverse().asDiagonal() * R;
    const MatrixXcd exact = -X.transpose() * (dK + s * s * dM) * X;
    const MatrixXcd change = by_turning(turn, z, R, s);
    // Half of the digits may go where modes are as close as is let pass.
    EXPECT_LT((change - exact).norm(), 1e-8 * exact.norm());
  }
}

TEST(ModalDerivative, TakesModalDampingAlong) {
  const Index n = 5;
  VectorXd omega(n);
  omega << 1.0, 2.0, 3.5, 4.0, 9.0;
  VectorXd zeta(n);
  zeta << 0.01, 0.02, 0.005, 0.03, 0.05;
  const MatrixXd K = omega.cwiseAbs2().asDiagonal();
  const MatrixXd dK = symmetric(n, 4);
  const MatrixXd dM = 0.1 * symmetric(n, 5);
  const MatrixXd R = symmetric(n, 6).leftCols(2);
  const complex<double> s(0.05, 3.0);
  const auto H = [&](double f) -> MatrixXcd {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
        K + f * dK, MatrixXd::Identity(n, n) + f * dM);
    const VectorXd w = modes.eigenvalues().cwiseSqrt();
    const MatrixXd P = modes.eigenvectors().transpose() * R;
    const VectorXcd z = own_stiffness(w, 2.0 * zeta.cwiseProduct(w), s);
    return P.transpose() * z.cwiseInverse().asDiagonal() * P;
  };
  const double h = 1e-5;
  const MatrixXcd difference = (H(h) - H(-h)) / (2.0 * h);
  const VectorXd d = 2.0 * zeta.cwiseProduct(omega);
  const ModalDerivative turn(MatrixXd::Identity(n, n),
                             omega,
                             {d, zeta.cwiseQuotient(omega)},
                             dK,
                             dM,
                             3.0);
  const MatrixXcd change = by_turning(turn, own_stiffness(omega, d, s), R, s);
  // Central differences: h^2 times a third derivative.
  EXPECT_LT((change - difference).norm(), 1e-7 * difference.norm());
}

}  // namespace
}  // namespace tapfit::updating
