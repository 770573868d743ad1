// How the modes of the base change with a parameter that its matrices depend
// on, in their own coordinates: k = Phi' dK Phi, m = Phi' dM Phi,
//
//   d lambda_j = k_jj - lambda_j m_jj,   d Phi = Phi A,
//   a_ij = (k_ij - lambda_j m_ij) / (lambda_j - lambda_i),  a_jj = -m_jj / 2
//
// (R. L. Fox, M. P. Kapoor, AIAA Journal 6(12), 1968, p. 2426). All modes of
// the base are known, so that the sum leaves nothing out, and the damping
// ratios go with the modes.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace tapfit::updating {

/// Of every mode of unit mass: d = 2 zeta omega, and what it gains with lambda.
struct DampingOfModes {
  Eigen::VectorXd d;
  Eigen::VectorXd slope;  ///< d d / d lambda
};

class ModalDerivative {
 public:
  /// @param phi the modes in the base's coordinates, omega theirs [rad/s]
  /// @param dK, dM by the parameter, in the base's coordinates; zero: 0 x 0
  /// @param largest the largest |s| that will be asked for [rad/s]
  ModalDerivative(const Eigen::MatrixXd& phi,
                  const Eigen::VectorXd& omega,
                  const DampingOfModes& damping,
                  const Eigen::MatrixXd& dK,
                  const Eigen::MatrixXd& dM,
                  double largest);

  /// A' R: what modal rows change by. @param R modes x any
  [[nodiscard]] Eigen::MatrixXd turned(const Eigen::MatrixXd& R) const {
    return A_.transpose() * R;
  }

  /// What the modes' own dynamic stiffness s^2 + d s + lambda changes by, in
  /// parts: d lambda and d d.
  [[nodiscard]] const Eigen::VectorXd& stiffness() const { return lambda_; }
  [[nodiscard]] const Eigen::VectorXd& damping() const { return d_; }

  /// Whether take_close() has anything to take off.
  [[nodiscard]] bool has_close() const { return !close_.empty(); }

  /// Takes Xo' dZ Xi of modes too close to each other for A, which is zero
  /// there, off a change of FRFs.
  /// @param Xo modes x responses
  /// @param Xi modes x references
  /// @param change responses x references
  void take_close(std::complex<double> s,
                  const Eigen::MatrixXcd& Xo,
                  const Eigen::MatrixXcd& Xi,
                  Eigen::MatrixXcd& change) const;

 private:
  struct Close {
    Eigen::Index i = 0;
    Eigen::Index j = 0;
    double k = 0.0;
    double c = 0.0;
    double m = 0.0;
  };

  Eigen::MatrixXd A_;
  Eigen::VectorXd lambda_;  // d lambda
  Eigen::VectorXd d_;       // d (2 zeta omega)
  std::vector<Close> close_;
};

}  // namespace tapfit::updating
