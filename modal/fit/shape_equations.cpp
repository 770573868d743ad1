#include "modal/fit/shape_equations.hpp"

#include <cmath>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Triplet = Eigen::Triplet<Complex>;

constexpr double held = 1e-12;  // eps, of a diagonal of one

}  // namespace

ShapeEquations::ShapeEquations(Edges edges,
                               const Eigen::VectorXcd& phi,
                               const Eigen::VectorXd& weight)
    : edges_(std::move(edges)), phi_(phi), weight_(weight) {
  const Index n = phi.size();
  std::vector<Triplet> entries;
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  for (std::size_t f = 0; f < edges_.size(); ++f) {
    const auto [a, b] = edges_[f];
    const double w2 = std::pow(weight(static_cast<Index>(f)), 2);
    if (a < 0 || b < 0 || w2 == 0.0) continue;
    if (a == b) {
      diagonal(a) += 4.0 * w2 * std::norm(phi(a));
      continue;
    }
    diagonal(a) += w2 * std::norm(phi(b));
    diagonal(b) += w2 * std::norm(phi(a));
    entries.emplace_back(a, b, w2 * std::conj(phi(b)) * phi(a));
    entries.emplace_back(b, a, w2 * std::conj(phi(a)) * phi(b));
  }
  unit_ = (diagonal.array() > 0.0)
              .select(diagonal.array().max(1e-300).rsqrt(), 0.0);
  for (Triplet& entry : entries) {
    entry = {entry.row(),
             entry.col(),
             unit_(entry.row()) * unit_(entry.col()) * entry.value()};
  }
  for (Index p = 0; p < n; ++p) entries.emplace_back(p, p, 1.0 + held);
  Eigen::SparseMatrix<Complex> normal(n, n);
  normal.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(normal);
}

Eigen::VectorXcd ShapeEquations::solve(const Eigen::VectorXcd& dP) const {
  Eigen::VectorXcd right = Eigen::VectorXcd::Zero(phi_.size());
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const auto f = static_cast<Index>(k);
    const auto [a, b] = edges_[k];
    if (a < 0 || b < 0) continue;
    const Complex weighted = weight_(f) * weight_(f) * dP(f);
    right(a) += std::conj(phi_(b)) * weighted;
    right(b) += std::conj(phi_(a)) * weighted;
  }
  const Eigen::VectorXcd scaled = unit_.cwiseProduct(right);
  return unit_.cwiseProduct(factor_.solve(scaled));
}

Eigen::VectorXd ShapeEquations::deviations() const {
  Eigen::VectorXd result(phi_.size());
  for (Index p = 0; p < phi_.size(); ++p) {
    const Eigen::VectorXcd column =
        factor_.solve(Eigen::VectorXcd::Unit(phi_.size(), p));
    result(p) = unit_(p) * std::sqrt(std::max(0.0, column(p).real()));
  }
  return result;
}

Index ShapeEquations::known() const { return (unit_.array() > 0.0).count(); }

}  // namespace tapfit::modal
