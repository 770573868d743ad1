// The regularisation parameter by the L-curve: log ||x|| over log ||S x - d||
// for the solutions of
//
//   min ||S x - d||^2 + lambda^2 ||x||^2       (eq. 25)
//
// bends where less regularisation only buys noise. The corner is the point of
// largest curvature: with eta = ||x||^2, rho = ||S x - d||^2, ' = d / d lambda
//
//   kappa = -2 eta rho / eta' (lambda^2 eta' rho + 2 lambda eta rho
//           + lambda^4 eta eta') / (lambda^4 eta^2 + rho^2)^(3/2)
//
// Source: P. C. Hansen, "The L-curve and its use in the numerical treatment of
// inverse problems", 2001, section 5 (sign and power of lambda as they follow
// from rho' = -lambda^2 eta').
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>

#include <optional>

namespace tapfit::updating {

/// A point of the curve.
struct LCurvePoint {
  double lambda = 0.0;
  double residual_norm = 0.0;
  double solution_norm = 0.0;
};

struct LCurve {
  Eigen::VectorXd lambda;         ///< ascending
  Eigen::VectorXd residual_norm;  ///< ||S x - d||
  Eigen::VectorXd solution_norm;  ///< ||x||
  Eigen::VectorXd curvature;      ///< of the curve in logarithms
  Eigen::Index corner = 0;        ///< position of the largest curvature
  /// Where a fit had its lambda from elsewhere.
  std::optional<LCurvePoint> used = {};
};

/// A system S x = d taken apart once, for any lambda.
class TikhonovSystem {
 public:
  /// @param S m x n sensitivities, m >= n
  /// @param d m, difference to explain
  TikhonovSystem(const Eigen::MatrixXd& S, const Eigen::VectorXd& d);

  /// x = (S'S + lambda^2 I)^-1 S' d (eq. 26); directions that S does not hold
  /// at all stay zero.
  [[nodiscard]] Eigen::VectorXd solve(double lambda) const;

  /// The curve over all that lambda may be: from rounding to the largest
  /// singular value.
  [[nodiscard]] LCurve l_curve(int points = 80) const;

  [[nodiscard]] const Eigen::VectorXd& singular_values() const {
    return svd_.singularValues();
  }

 private:
  Eigen::JacobiSVD<Eigen::MatrixXd> svd_;
  Eigen::VectorXd beta_;  // U' d
  double outside_ = 0.0;  // ||d - U U' d||^2
};

}  // namespace tapfit::updating
