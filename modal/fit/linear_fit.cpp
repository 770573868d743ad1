#include "modal/fit/linear_fit.hpp"

#include "modal/poles/fit_columns.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Q R = phi, by Cholesky's factor of phi' phi, twice for orthogonality to
/// rounding (Y. Yamamoto, Y. Nakatsukasa, Y. Yanagisawa, T. Fukaya, ETNA 44,
/// 2015, p. 306): products of matrices, where Householder's reflections go over
/// the columns one by one. Columns too alike for it are left to those.
void orthogonalise(Eigen::MatrixXd phi, LinearFit& linear) {
  constexpr double alike = 1e-12;  // condition 1e6, squared
  const Index n = phi.cols();
  linear.R.setIdentity(n, n);
  for (int pass = 0; pass < 2; ++pass) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(phi.transpose());
    const Eigen::LLT<Eigen::MatrixXd> factor(gram);
    if (factor.info() != Eigen::Success || factor.rcond() < alike) {
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(phi);
      linear.Q = qr.householderQ() * Eigen::MatrixXd::Identity(phi.rows(), n);
      linear.R =
          qr.matrixQR().topRows(n).triangularView<Eigen::Upper>() * linear.R;
      return;
    }
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(phi);
    linear.R = factor.matrixU() * linear.R;
  }
  linear.Q = std::move(phi);
}

/// Cholesky's factor of the products of columns of unit length; those that
/// coincide to rounding are held apart by what is far below the noise.
Eigen::MatrixXd factor_of(const Eigen::MatrixXd& gram) {
  constexpr double least = 1e-14;  // rounding of the products
  constexpr double most = 1e-6;
  Eigen::LLT<Eigen::MatrixXd> factor(gram);
  for (double raise = least;
       (factor.info() != Eigen::Success || factor.rcond() < least) &&
       raise < most;
       raise *= 10.0) {
    Eigen::MatrixXd raised = gram;
    raised.diagonal().array() += raise;
    factor.compute(raised);
  }
  return factor.matrixU();
}

/// Phi on all lines, weighted by v.
Eigen::MatrixXd weighted_columns(const WeightedFrfs& curves,
                                 const Eigen::VectorXcd& poles) {
  const Eigen::VectorXd& v = curves.weights.line;
  Eigen::MatrixXd columns = model_columns(curves, poles, 0, curves.lines());
  columns = v.replicate<2, 1>().asDiagonal() * columns;
  return columns;
}

}  // namespace

Eigen::MatrixXd explained_by(const LinearFit& linear,
                             const Eigen::MatrixXd& x) {
  return linear.R.triangularView<Eigen::Upper>().transpose().solve(
      linear.scale.cwiseInverse().asDiagonal() * x);
}

Eigen::MatrixXd coefficients_for(const LinearFit& linear,
                                 const Eigen::MatrixXd& x) {
  return linear.scale.cwiseInverse().asDiagonal() *
         linear.R.triangularView<Eigen::Upper>().solve(x);
}

LinearFit fit_by_columns(const WeightedFrfs& curves,
                         const Eigen::VectorXcd& poles) {
  LinearFit linear;
  const Eigen::MatrixXd& y = curves.sums.frfs;
  Eigen::MatrixXd phi = weighted_columns(curves, poles);
  linear.scale = phi.colwise().norm().transpose().cwiseMax(1e-300);
  phi = phi * linear.scale.cwiseInverse().asDiagonal();
  orthogonalise(std::move(phi), linear);
  // A diagonal of zero would be two equal columns.
  for (Index c = 0; c < linear.R.cols(); ++c) {
    if (std::abs(linear.R(c, c)) < 1e-12) linear.R(c, c) = 1e-12;
  }
  linear.explained = linear.Q.transpose() * y;
  linear.coefficients = coefficients_for(linear, linear.explained);
  linear.left = y - linear.Q * linear.explained;
  linear.misfit = linear.left.squaredNorm();
  return linear;
}

LinearFit fit_by_products(const WeightedFrfs& curves,
                          const Eigen::VectorXcd& poles) {
  LinearFit linear;
  linear.sums = pole_sums(curves, poles);
  const ColumnProducts products = column_products(curves, poles, linear.sums);
  linear.scale = products.gram.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const auto unit = linear.scale.cwiseInverse().asDiagonal();
  linear.R = factor_of(unit * products.gram * unit);
  linear.explained = explained_by(linear, products.frfs);
  linear.coefficients = coefficients_for(linear, linear.explained);
  linear.misfit =
      std::max(0.0, curves.sums.power - linear.explained.squaredNorm());
  return linear;
}

LinearFit fit_linear(const WeightedFrfs& curves,
                     const Eigen::VectorXcd& poles) {
  return curves.sums.are_few() ? fit_by_columns(curves, poles)
                               : fit_by_products(curves, poles);
}

Eigen::MatrixXd orthonormal_columns(const WeightedFrfs& curves,
                                    const Eigen::VectorXcd& poles,
                                    const LinearFit& linear) {
  if (curves.sums.are_few()) return linear.Q;
  Eigen::MatrixXd Q = weighted_columns(curves, poles) *
                      linear.scale.cwiseInverse().asDiagonal();
  linear.R.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(Q);
  return Q;
}

Eigen::MatrixXd model_columns(const WeightedFrfs& curves,
                              const Eigen::VectorXcd& poles,
                              Index begin,
                              Index count) {
  const Eigen::VectorXcd s = curves.s.segment(begin, count);
  const Eigen::MatrixXcd modes = pole_columns(s, poles, 1);
  const Eigen::MatrixXcd terms = term_columns(residual_basis(s, curves.s));
  Eigen::MatrixXd columns(2 * count, modes.cols() + terms.cols());
  columns << stack(modes), stack(terms);
  return columns;
}

}  // namespace tapfit::modal
