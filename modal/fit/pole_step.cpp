#include "modal/fit/pole_step.hpp"

#include "modal/poles/fit_columns.hpp"

#include <Eigen/Dense>

#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Residues of u H, n_frfs x n_modes.
Eigen::MatrixXcd residues_of(const LinearFit& linear, Index modes) {
  Eigen::MatrixXcd c(linear.coefficients.cols(), modes);
  for (Index r = 0; r < modes; ++r) {
    c.col(r).real() = linear.coefficients.row(2 * r).transpose();
    c.col(r).imag() = linear.coefficients.row(2 * r + 1).transpose();
  }
  return c;
}

/// C' G C summed over the FRFs, whose residues c are. A 2 x 2 block of G maps z
/// to g z + h conj(z), so that its product maps z to
/// sum conj(c_r) c_q g z + sum conj(c_r c_q) h conj(z).
Eigen::MatrixXd summed(const Eigen::MatrixXd& G, const Eigen::MatrixXcd& c) {
  const Index modes = c.cols();
  const Eigen::MatrixXcd same = c.adjoint() * c;
  const Eigen::MatrixXcd other = c.adjoint() * c.conjugate();
  Eigen::MatrixXd result(G.rows(), G.cols());
  for (Index r = 0; r < modes; ++r) {
    for (Index q = 0; q < modes; ++q) {
      const Eigen::Matrix2d B = G.block<2, 2>(2 * r, 2 * q);
      const Complex g = 0.5 * Complex(B(0, 0) + B(1, 1), B(1, 0) - B(0, 1));
      const Complex h = 0.5 * Complex(B(0, 0) - B(1, 1), B(1, 0) + B(0, 1));
      const Complex u = same(r, q) * g;
      const Complex v = other(r, q) * h;
      result.block<2, 2>(2 * r, 2 * q) << (u + v).real(), (v - u).imag(),
          (u + v).imag(), (u - v).real();
    }
  }
  return result;
}

/// sum_f C_f' x_f for the columns x_f.
Eigen::VectorXd along_residues(const Eigen::MatrixXd& x,
                               const LinearFit& linear) {
  Eigen::VectorXd result(x.rows());
  for (Index r = 0; r < x.rows() / 2; ++r) {
    const auto re = linear.coefficients.row(2 * r);
    const auto im = linear.coefficients.row(2 * r + 1);
    result(2 * r) = re.dot(x.row(2 * r)) + im.dot(x.row(2 * r + 1));
    result(2 * r + 1) = re.dot(x.row(2 * r + 1)) - im.dot(x.row(2 * r));
  }
  return result;
}

}  // namespace

PoleStep pole_step(const WeightedFrfs& curves,
                   const Eigen::VectorXcd& poles,
                   const LinearFit& linear) {
  if (curves.sums.are_few()) {
    const Eigen::MatrixXd e = projected_derivatives(curves, poles, linear);
    return {summed(e.transpose() * e, residues_of(linear, poles.size())),
            along_residues(e.transpose() * linear.left, linear)};
  }
  // e' e = E' E - K' K and e' y = E' y - K' Q' y with K = Q' E.
  const DerivativeProducts E = derivative_products(curves, poles, linear.sums);
  const Eigen::MatrixXd K = explained_by(linear, E.columns);
  const Eigen::MatrixXd G = E.gram - K.transpose() * K;
  const Eigen::MatrixXd left = E.frfs - K.transpose() * linear.explained;
  return {summed(G, residues_of(linear, poles.size())),
          along_residues(left, linear)};
}

Eigen::MatrixXd projected_derivatives(const WeightedFrfs& curves,
                                      const Eigen::VectorXcd& poles,
                                      const LinearFit& linear) {
  const Eigen::MatrixXd Q = orthonormal_columns(curves, poles, linear);
  const Eigen::MatrixXd E = stack(curves.weights.line.asDiagonal() *
                                  pole_columns(curves.s, poles, 2));
  return E - Q * (Q.transpose() * E);
}

Eigen::VectorXd damped_solve(const PoleStep& step, double mu) {
  const Eigen::VectorXd d = step.normal.diagonal().cwiseMax(1e-300).cwiseSqrt();
  Eigen::MatrixXd N = d.cwiseInverse().asDiagonal() * step.normal *
                      d.cwiseInverse().asDiagonal();
  N.diagonal().array() += mu + 1e-14;
  const Eigen::VectorXd g = step.gradient.cwiseQuotient(d);
  return N.ldlt().solve(g).cwiseQuotient(d);
}

Eigen::MatrixXd with_residues(const Eigen::MatrixXd& G,
                              const LinearFit& linear,
                              const Eigen::MatrixXd& weight) {
  return summed(G, residues_of(linear, G.cols() / 2).cwiseProduct(weight));
}

}  // namespace tapfit::modal
