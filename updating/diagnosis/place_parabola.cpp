#include "updating/diagnosis/place_parabola.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Directions, in space, that the places tried lie along; columns of the length
// of a grid spacing.
MatrixXd directions(const std::vector<TriedPlace>& tried,
                    const Vector3d& from) {
  constexpr double flat = 0.2;  // of the largest extent
  MatrixXd off(3, static_cast<Index>(tried.size()));
  for (std::size_t k = 0; k < tried.size(); ++k) {
    off.col(static_cast<Index>(k)) = tried[k].at - from;
  }
  const double spacing = 2.0 * off.colwise().norm().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(off * off.transpose()));
  const VectorXd& squares = solver.eigenvalues();
  const double least = flat * flat * std::max(squares.maxCoeff(), 0.0);
  const Index count = std::min<Index>(2, (squares.array() > least).count());
  return spacing * solver.eigenvectors().rightCols(count);
}

// Of log likelihood: as far below the top it is like a parabola.
constexpr double parabolic = 4.0;

// 1, z, squares, and the product where there are places enough to tell.
VectorXd terms(const VectorXd& z, bool product) {
  const Index d = z.size();
  VectorXd row(1 + 2 * d + (product ? 1 : 0));
  row.head(1 + 2 * d) << 1.0, z, 0.5 * z.cwiseAbs2();
  if (product) row(1 + 2 * d) = z(0) * z(1);
  return row;
}

// Least squares. Places on one line, or nearly, tell nothing across it: terms
// that go together share.
MatrixXd solved(const MatrixXd& A, const MatrixXd& values) {
  constexpr double told = 1e-3;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> least_squares;
  least_squares.setThreshold(told);
  least_squares.compute(A);
  return least_squares.solve(values);
}

}  // namespace

std::optional<PlaceParabola> parabola_through(
    const std::vector<TriedPlace>& tried, const TriedPlace& best) {
  const Vector3d& from = best.at;
  PlaceParabola q;
  q.axes = directions(tried, from);
  const Index d = q.axes.cols();
  const auto n = static_cast<Index>(tried.size());
  const bool product = d == 2 && n >= 6;
  if (d == 0 || n < 1 + 2 * d) return std::nullopt;
  MatrixXd A(n, 1 + 2 * d + (product ? 1 : 0));
  VectorXd values(n);
  MatrixXd sizes(n, best.log_p.size());
  VectorXd weight(n);
  double flattest = -1e300;  // curvature towards any of them
  for (Index k = 0; k < n; ++k) {
    const TriedPlace& t = tried[static_cast<std::size_t>(k)];
    const Vector3d off = t.at - from;
    const VectorXd z = (q.axes.transpose() * off).array() /
                       q.axes.colwise().squaredNorm().transpose().array();
    A.row(k) = terms(z, product).transpose();
    values(k) = t.log_likelihood - best.log_likelihood;
    sizes.row(k) = (t.log_p - best.log_p).transpose();
    // Far down the likelihood is no parabola.
    weight(k) = std::exp(0.5 * values(k) / parabolic);
    if (z.norm() > 0.0) {
      flattest = std::max(flattest, 2.0 * values(k) / z.squaredNorm());
    }
  }
  const VectorXd fitted =
      solved(weight.asDiagonal() * A, VectorXd(weight.asDiagonal() * values));
  MatrixXd H = fitted.segment(1 + d, d).asDiagonal();
  if (product) H(0, 1) = H(1, 0) = fitted(1 + 2 * d);
  // A ridge where the parabola misses the top, and what tells next to nothing
  // of the place: a spacing's deviation.
  constexpr double least_curvature = -1.0;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(H);
  const VectorXd curvature =
      solver.eigenvalues().cwiseMin(std::min(flattest, least_curvature));
  const MatrixXd& turn = solver.eigenvectors();
  q.covariance =
      turn * (-curvature.cwiseInverse()).asDiagonal() * turn.transpose();
  q.top = q.covariance * fitted.segment(1, d);
  // Sizes bend little where the likelihood has its top.
  q.slope = solved(weight.asDiagonal() * A.leftCols(1 + d),
                   weight.asDiagonal() * sizes)
                .bottomRows(d)
                .transpose();
  return q;
}

std::vector<double> size_deviations(const PlaceParabola& q) {
  std::vector<double> sd;
  for (Index k = 0; k < q.slope.rows(); ++k) {
    const VectorXd slope = q.slope.row(k).transpose();
    sd.push_back(std::sqrt(slope.dot(q.covariance * slope)));
  }
  return sd;
}

}  // namespace tapfit::updating
