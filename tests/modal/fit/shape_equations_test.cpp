#include "modal/fit/shape_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <complex>

namespace tapfit::modal {
namespace {

using Eigen::Index;

// Against the dense pseudo-inverse of J: a driving point, two references, and
// a point that no FRF reaches.
TEST(ShapeEquations, AreThoseOfTheDenseJacobian) {
  constexpr Index points = 7;
  const Edges edges{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {1, 3},
                    {2, 3}, {3, 3}, {4, 3}, {5, 3}};
  const auto count = static_cast<Index>(edges.size());
  const Eigen::VectorXcd phi = Eigen::VectorXcd::Random(points);
  const Eigen::VectorXd w =
      Eigen::VectorXd::Random(count).cwiseAbs().array() + 0.5;
  Eigen::MatrixXcd J = Eigen::MatrixXcd::Zero(count, points);
  for (Index f = 0; f < count; ++f) {
    const auto [a, b] = edges[static_cast<std::size_t>(f)];
    J(f, a) += w(f) * phi(b);
    J(f, b) += w(f) * phi(a);
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd> dense(J);
  const Eigen::VectorXcd dP = Eigen::VectorXcd::Random(count);
  const ShapeEquations sparse(edges, phi, w);
  EXPECT_EQ(sparse.known(), 6);
  const Eigen::VectorXcd weighted = w.cwiseProduct(dP);
  const Eigen::VectorXcd step = dense.solve(weighted);
  // What holds the scale is 1e-12 of the diagonal, times the condition squared.
  EXPECT_LT((sparse.solve(dP) - step).norm(), 1e-8 * step.norm());
  const Eigen::VectorXd sd =
      Eigen::MatrixXcd(dense.pseudoInverse()).rowwise().norm();
  EXPECT_LT((sparse.deviations() - sd).norm(), 1e-8 * sd.norm());
}

}  // namespace
}  // namespace tapfit::modal
