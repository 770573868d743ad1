#include "modal/fit/shape_uncertainty.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/linear_fit.hpp"
#include "modal/fit/shape_equations.hpp"
#include "modal/poles/fit_columns.hpp"

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

/// Least squares over all FRFs of a mode, weighted by the residues' sd.
Eigen::VectorXd scaled_deviations(const ShapeGraph& graph,
                                  const Eigen::VectorXcd& P,
                                  const Eigen::VectorXd& sd,
                                  const Eigen::VectorXcd& phi) {
  const std::vector<Index> rows = rows_of(graph);
  const Complex turn = turn_of(graph, rows, P, phi);
  Edges edges;
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(P.size());
  double left = 0.0;
  Index used = 0;
  for (Index f = 0; f < P.size(); ++f) {
    const auto [first, second] = graph.edges[static_cast<std::size_t>(f)];
    const Index a = rows[static_cast<std::size_t>(first)];
    const Index b = rows[static_cast<std::size_t>(second)];
    edges.emplace_back(a, b);
    if (a < 0 || b < 0 || !(sd(f) > 0.0)) continue;
    weight(f) = 1.0 / sd(f);
    left += std::norm((turn * P(f) - phi(a) * phi(b)) / sd(f));
    ++used;
  }
  const ShapeEquations equations(std::move(edges), phi, weight);
  const Index spare = used - equations.known();
  const double scale =
      spare > 0 ? std::max(1.0, left / static_cast<double>(spare)) : 1.0;
  return std::sqrt(scale) * equations.deviations();
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

Eigen::MatrixXd residue_variance(const WeightedFrfs& curves,
                                 const ModalFit& fit,
                                 NoiseFrom from) {
  return residue_variance(curves, fit, weighted_noise(curves, fit, from));
}

Eigen::MatrixXd residue_variance(const WeightedFrfs& curves,
                                 const ModalFit& fit,
                                 const Noise& noise) {
  const Index modes = fit.poles.size();
  Eigen::MatrixXd variance(curves.count(), modes);
  if (modes == 0) return variance;
  const LinearFit linear = fit_linear(curves, fit.poles);
  const Index n = linear.scale.size();
  const Eigen::MatrixXcd X =
      noise.per_line.asDiagonal() *
      unstack(orthonormal_columns(curves, fit.poles, linear) *
              coefficients_for(linear, Eigen::MatrixXd::Identity(n, n))
                  .topRows(2 * modes)
                  .transpose());
  const Eigen::MatrixXd V = correlated_gram(X, curves.sigma / curves.spacing);
  const Eigen::MatrixXd at_modes = noise_at_modes(noise, X);
  for (Index r = 0; r < modes; ++r) {
    const double unit = V(2 * r, 2 * r) + V(2 * r + 1, 2 * r + 1);
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
  const auto operations =
      20.0 * static_cast<double>(residues.size() * residues.rows());
  const auto count = static_cast<std::size_t>(poles.size());
  for_each_parallel(count, operations, [&](std::size_t k) {
    const auto r = static_cast<Index>(k);
    const Complex factor(0.0, 2.0 * poles(r).imag());
    const Eigen::VectorXcd P = factor * residues.col(r);
    const Eigen::VectorXd sd_P = std::abs(factor) * variance.col(r).cwiseSqrt();
    const auto deviations =
        graph.scaled ? scaled_deviations : unscaled_deviations;
    sd.col(r) = deviations(graph, P, sd_P, shapes.col(r));
  });
  return sd;
}

}  // namespace tapfit::modal
