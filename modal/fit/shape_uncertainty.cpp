#include "modal/fit/shape_uncertainty.hpp"

#include "modal/fit/fit_columns.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Row of each point of the graph in the shapes, -1 for those left out.
std::vector<Index> rows_of(const ShapeGraph& graph) {
  std::vector<Index> rows(graph.points.size(), -1);
  for (std::size_t k = 0; k < graph.kept.size(); ++k) {
    rows[static_cast<std::size_t>(graph.kept[k])] = static_cast<Index>(k);
  }
  return rows;
}

/// What products of the shape's values were turned by when it was made real.
Complex turn_of(const ShapeGraph& graph,
                const std::vector<Index>& rows,
                const Eigen::VectorXcd& P,
                const Eigen::VectorXcd& phi) {
  Complex sum = 0.0;
  for (Index f = 0; f < P.size(); ++f) {
    const auto [first, second] = graph.edges[static_cast<std::size_t>(f)];
    const Index a = rows[static_cast<std::size_t>(first)];
    const Index b = rows[static_cast<std::size_t>(second)];
    if (a >= 0 && b >= 0) sum += std::conj(P(f)) * phi(a) * phi(b);
  }
  return std::abs(sum) > 0.0 ? sum / std::abs(sum) : Complex(1.0);
}

/// Least squares over all FRFs of a mode: J weighted by the residues' sd.
Eigen::VectorXd scaled_deviations(const ShapeGraph& graph,
                                  const Eigen::VectorXcd& P,
                                  const Eigen::VectorXd& sd,
                                  const Eigen::VectorXcd& phi) {
  const std::vector<Index> rows = rows_of(graph);
  Eigen::MatrixXcd J = Eigen::MatrixXcd::Zero(P.size(), phi.size());
  Eigen::VectorXcd left = Eigen::VectorXcd::Zero(P.size());
  const Complex turn = turn_of(graph, rows, P, phi);
  Index used = 0;
  for (Index f = 0; f < P.size(); ++f) {
    const auto [first, second] = graph.edges[static_cast<std::size_t>(f)];
    const Index a = rows[static_cast<std::size_t>(first)];
    const Index b = rows[static_cast<std::size_t>(second)];
    if (a < 0 || b < 0 || !(sd(f) > 0.0)) continue;
    J(f, a) += phi(b) / sd(f);
    J(f, b) += phi(a) / sd(f);
    left(f) = (turn * P(f) - phi(a) * phi(b)) / sd(f);
    ++used;
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd> solver(J);
  const Index spare = used - solver.rank();
  const double scale =
      spare > 0 ? std::max(1.0, left.squaredNorm() / static_cast<double>(spare))
                : 1.0;
  const Eigen::MatrixXcd inverse = solver.pseudoInverse();
  return std::sqrt(scale) * inverse.rowwise().norm();
}

/// From the best FRF of each point alone.
Eigen::VectorXd unscaled_deviations(const ShapeGraph& graph,
                                    const Eigen::VectorXcd& P,
                                    const Eigen::VectorXd& sd,
                                    const Eigen::VectorXcd& phi) {
  const std::vector<Index> rows = rows_of(graph);
  Eigen::VectorXd share = Eigen::VectorXd::Ones(phi.size());
  for (Index f = 0; f < P.size(); ++f) {
    const auto [a, b] = graph.edges[static_cast<std::size_t>(f)];
    const Index row = std::max(rows[static_cast<std::size_t>(a)],
                               rows[static_cast<std::size_t>(b)]);
    if (row < 0 || std::abs(P(f)) == 0.0) continue;
    share(row) = std::min(share(row), sd(f) / std::abs(P(f)));
  }
  return share.cwiseProduct(phi.cwiseAbs());
}

}  // namespace

Eigen::MatrixXd residue_variance(const Curves& curves,
                                 const ModalFit& fit,
                                 NoiseFrom from) {
  const Index modes = fit.poles.size();
  Eigen::MatrixXd variance(curves.count(), modes);
  if (modes == 0) return variance;
  const Eigen::MatrixXcd terms =
      term_columns(residual_basis(curves.s, curves.s));
  Eigen::MatrixXcd columns(curves.lines(), 2 * modes + terms.cols());
  columns << pole_columns(curves.s, fit.poles, 1), terms;
  Eigen::MatrixXd phi = stack(fit.line_weight.asDiagonal() * columns);
  const Eigen::VectorXd scale =
      phi.colwise().norm().transpose().cwiseMax(1e-300);
  phi = phi * scale.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(phi);
  const Index n = phi.cols();
  const Eigen::MatrixXd Q =
      qr.householderQ() * Eigen::MatrixXd::Identity(phi.rows(), n);
  Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  // A diagonal of zero would be two equal columns.
  R.diagonal() = (R.diagonal().array().abs() < 1e-12)
                     .select(Eigen::VectorXd::Constant(n, 1e-12), R.diagonal());
  const Eigen::MatrixXd R_inverse =
      R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::MatrixXd inverse = Q * R_inverse.topRows(2 * modes).transpose();
  const Noise noise = weighted_noise(curves, fit, from);
  const Eigen::MatrixXcd X = noise.per_line.asDiagonal() * unstack(inverse);
  const Eigen::MatrixXd V =
      0.5 * (X.adjoint() * correlate(X, curves.sigma / curves.spacing)).real();
  const Eigen::MatrixXd at_modes = noise_at_modes(noise, X);
  for (Index r = 0; r < modes; ++r) {
    const double unit = V(2 * r, 2 * r) / std::pow(scale(2 * r), 2) +
                        V(2 * r + 1, 2 * r + 1) / std::pow(scale(2 * r + 1), 2);
    variance.col(r) =
        unit * at_modes.col(r).cwiseQuotient(fit.frf_weight).cwiseAbs2();
  }
  return variance;
}

Eigen::MatrixXd shape_deviations(const ShapeGraph& graph,
                                 const Eigen::MatrixXcd& residues,
                                 const Eigen::MatrixXd& variance,
                                 const Eigen::VectorXcd& poles,
                                 const Eigen::MatrixXcd& shapes) {
  Eigen::MatrixXd sd(shapes.rows(), shapes.cols());
  for (Index r = 0; r < poles.size(); ++r) {
    const Complex factor(0.0, 2.0 * poles(r).imag());
    const Eigen::VectorXcd P = factor * residues.col(r);
    const Eigen::VectorXd sd_P = std::abs(factor) * variance.col(r).cwiseSqrt();
    const auto deviations =
        graph.scaled ? scaled_deviations : unscaled_deviations;
    sd.col(r) = deviations(graph, P, sd_P, shapes.col(r));
  }
  return sd;
}

}  // namespace tapfit::modal
