#include "updating/modal_updating/modal_uncertainty.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A^-1 over the directions in which A is not nothing, and for each parameter
// how much of it lies in the others.
struct Inverse {
  MatrixXd of;
  VectorXd lost;  // 0..1
};

Inverse invert(const MatrixXd& A) {
  constexpr double kNothing = 1e-13;  // rounding of J'J
  const VectorXd scale = A.diagonal().unaryExpr(
      [](double a) { return a > 0.0 ? 1.0 / std::sqrt(a) : 0.0; });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scale.asDiagonal() * A *
                                                       scale.asDiagonal());
  const VectorXd& s = solver.eigenvalues();
  const MatrixXd& V = solver.eigenvectors();
  VectorXd inverse = VectorXd::Zero(s.size());
  VectorXd lost = VectorXd::Zero(s.size());
  for (Index k = 0; k < s.size(); ++k) {
    if (s(k) > kNothing * s.maxCoeff() && s(k) > 0.0) {
      inverse(k) = 1.0 / s(k);
    } else {
      lost += V.col(k).cwiseAbs2();
    }
  }
  return {scale.asDiagonal() * V * inverse.asDiagonal() * V.transpose() *
              scale.asDiagonal(),
          lost};
}

// One kind of data: its share of the normal matrix, and s^2.
struct Kind {
  MatrixXd F;
  double squares = 0.0;  // r'Wr
  double data = 0.0;     // tr W

  [[nodiscard]] double widened(const MatrixXd& inverse) const {
    const double left = data - F.cwiseProduct(inverse).sum();
    return std::max(1.0, squares / std::max(1.0, left));
  }
};

}  // namespace

ModalUncertainty modal_uncertainty(const MatrixXd& J,
                                   const ModalResidual& residual,
                                   Index frequencies,
                                   const VectorXd& precision) {
  const MatrixXd weighted = residual.weight.cwiseSqrt().asDiagonal() * J;
  const Index points = (J.rows() - frequencies) / frequencies;
  Kind by_frequency;
  Kind by_shape;
  by_frequency.F = by_shape.F = MatrixXd::Zero(J.cols(), J.cols());
  const auto add = [&](Kind& kind, Index from, Index rows) {
    const auto part = weighted.middleRows(from, rows);
    const auto w = residual.weight.segment(from, rows);
    kind.F += part.transpose() * part;
    kind.data += w.sum();
    kind.squares +=
        w.cwiseProduct(residual.r.segment(from, rows).cwiseAbs2()).sum();
  };
  for (const modal::Pair& pair : residual.pairs) {
    add(by_frequency, pair.measured, 1);
    add(by_shape, frequencies + pair.measured * points, points);
  }
  MatrixXd A = by_frequency.F + by_shape.F;
  A.diagonal() += precision;
  const Inverse inverse = invert(A);
  ModalUncertainty result;
  result.covariance =
      inverse.of *
      (A + (by_frequency.widened(inverse.of) - 1.0) * by_frequency.F +
       (by_shape.widened(inverse.of) - 1.0) * by_shape.F) *
      inverse.of;
  result.standard_error = result.covariance.diagonal().cwiseSqrt();
  for (Index k = 0; k < inverse.lost.size(); ++k) {
    if (inverse.lost(k) < 1e-6) continue;
    result.standard_error(k) = std::numeric_limits<double>::infinity();
  }
  MatrixXd S = MatrixXd::Zero(std::max(J.rows(), J.cols()), J.cols());
  S.topRows(J.rows()) = weighted;
  result.identifiability = identifiability(S);
  return result;
}

}  // namespace tapfit::updating
