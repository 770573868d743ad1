#include "modal/poles/fit_sums.hpp"

#include "modal/poles/fit_columns.hpp"

#include <utility>

namespace tapfit::modal {
namespace {

// Values of FRFs and columns up to which a pass over them costs less than the
// sums do.
constexpr Eigen::Index few = 100'000;
constexpr Eigen::Index columns = 40;  // of a model of some 15 modes

}  // namespace

SeparableWeights separate_weights(const Eigen::MatrixXd& weight) {
  Eigen::ArrayXd per_line = Eigen::ArrayXd::Zero(weight.rows());
  Eigen::ArrayXd per_frf(weight.cols());
  for (Eigen::Index f = 0; f < weight.cols(); ++f) {
    const Eigen::ArrayXd logs = weight.col(f).array().log();
    per_line += logs / static_cast<double>(weight.cols());
    per_frf(f) = logs.mean();
  }
  return {(per_line - per_frf.mean()).exp(), per_frf.exp()};
}

FitSums fit_sums(const Eigen::VectorXcd& s,
                 const Eigen::MatrixXcd& H,
                 const SeparableWeights& weights) {
  if (s.size() * (H.cols() + columns) < few) {
    return {stack(weights.line.asDiagonal() * H * weights.frf.asDiagonal()),
            {},
            {},
            {},
            0.0};
  }
  const Eigen::MatrixXcd basis = residual_basis(s, s);
  const Eigen::VectorXd power = weights.line.cwiseAbs2();
  FitSums sums;
  const Eigen::MatrixXcd terms = term_columns(basis);
  sums.term_term = (terms.adjoint() * power.asDiagonal() * terms).real();
  sums.term_frf = (terms.adjoint() * power.asDiagonal() * H).real() *
                  weights.frf.asDiagonal();
  sums.power =
      (power.transpose() * H.cwiseAbs2() * weights.frf.cwiseAbs2().asDiagonal())
          .sum();
  // One column of memory per line: all FRFs of a line are needed together.
  Eigen::MatrixXcd x(H.cols() + basis.cols() + 1, s.size());
  x.topRows(H.cols()) = weights.frf.asDiagonal() * H.transpose();
  x.middleRows(H.cols(), basis.cols()) = basis.transpose();
  x.bottomRows(1) = s.cwiseProduct(s).transpose();
  const Eigen::VectorXcd s2 = s.cwiseProduct(s).conjugate();
  x.array().rowwise() *= power.cwiseProduct(s2).transpose().array();
  sums.lines = CauchySums(std::move(x));
  return sums;
}

}  // namespace tapfit::modal
