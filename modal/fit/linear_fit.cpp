#include "modal/fit/linear_fit.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/poles/fit_columns.hpp"

#include <algorithm>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr Index kLinesAtOnce = 128;  // of a chunk: stays in the cache

/// Cholesky's factor; columns that coincide to rounding are held apart by what
/// is far below the noise.
Eigen::LLT<Eigen::MatrixXd> factored(Eigen::MatrixXd gram) {
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
  return factor;
}

Eigen::MatrixXcd unweighted_columns(const Curves& curves,
                                    const Eigen::VectorXcd& poles,
                                    Index begin,
                                    Index count) {
  const Eigen::VectorXcd s = curves.s.segment(begin, count);
  const Eigen::MatrixXcd modes = pole_columns(s, poles, 1);
  const Eigen::MatrixXcd terms = term_columns(residual_basis(s, curves.s));
  Eigen::MatrixXcd columns(count, modes.cols() + terms.cols());
  columns << modes, terms;
  return columns;
}

/// Rows of Re and Im of each residue, then of each term: n_columns x n_frfs.
Eigen::MatrixXd coefficients_of(const ModalFit& fit) {
  Eigen::MatrixXcd all(fit.residues.rows(),
                       fit.residues.cols() + fit.terms.cols());
  all << fit.residues, fit.terms;
  Eigen::MatrixXd result(2 * all.cols(), all.rows());
  for (Index c = 0; c < all.cols(); ++c) {
    result.row(2 * c) = all.col(c).real().transpose();
    result.row(2 * c + 1) = all.col(c).imag().transpose();
  }
  return result;
}

}  // namespace

Eigen::MatrixXd whitened(const LinearFit& linear, const Eigen::MatrixXd& x) {
  return linear.factor.matrixL().solve(
      linear.scale.cwiseInverse().asDiagonal() * x);
}

Eigen::MatrixXd normal_solve(const LinearFit& linear,
                             const Eigen::MatrixXd& x) {
  return linear.scale.cwiseInverse().asDiagonal() *
         linear.factor.matrixU().solve(whitened(linear, x));
}

LinearFit fit_linear(const Curves& curves, const Eigen::VectorXcd& poles) {
  LinearFit linear;
  linear.sums = pole_sums(curves, poles);
  const ColumnProducts products = column_products(curves, poles, linear.sums);
  linear.scale = products.gram.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const auto unit = linear.scale.cwiseInverse().asDiagonal();
  linear.factor = factored(unit * products.gram * unit);
  linear.whitened = whitened(linear, products.frfs);
  linear.coefficients =
      unit * linear.factor.matrixU().solve(linear.whitened);
  linear.misfit = std::max(
      0.0, curves.sums.power - linear.whitened.squaredNorm());
  return linear;
}

Eigen::MatrixXd model_columns(const Curves& curves,
                              const Eigen::VectorXcd& poles,
                              Index begin,
                              Index count) {
  return stack(curves.weights.line.segment(begin, count).asDiagonal() *
               unweighted_columns(curves, poles, begin, count));
}

Eigen::MatrixXcd fitted_accelerance(const Curves& curves,
                                    const ModalFit& fit,
                                    Index begin,
                                    Index count) {
  return unstack(
      stack(unweighted_columns(curves, fit.poles, begin, count)) *
      coefficients_of(fit));
}

Eigen::MatrixXcd fitted_accelerance(const Curves& curves,
                                    const ModalFit& fit) {
  Eigen::MatrixXcd H(curves.lines(), curves.count());
  const Eigen::MatrixXd coefficients = coefficients_of(fit);
  const Index chunks = (curves.lines() + kLinesAtOnce - 1) / kLinesAtOnce;
  for_each_parallel(static_cast<std::size_t>(chunks), [&](std::size_t k) {
    const Index begin = static_cast<Index>(k) * kLinesAtOnce;
    const Index count = std::min(kLinesAtOnce, curves.lines() - begin);
    H.middleRows(begin, count) =
        unstack(stack(unweighted_columns(curves, fit.poles, begin, count)) *
                coefficients);
  });
  return H;
}

}  // namespace tapfit::modal
