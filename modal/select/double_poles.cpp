#include "modal/select/double_poles.hpp"

#include "modal/fit/shape_uncertainty.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double derivative_step = 1e-2;  // half bandwidths, for the derivative

double step_at(const Complex& pole) { return -derivative_step * pole.real(); }

}  // namespace

ModalFit expanded_fit(const WeightedFrfs& curves,
                      const ModalFit& fit,
                      Index r) {
  const double step = step_at(fit.poles(r));
  Eigen::VectorXcd poles(fit.poles.size() + 1);
  poles << fit.poles, fit.poles(r) + step;
  poles(r) -= step;
  return fit_residues(curves, poles);
}

PoleExpansion expand_pole(const WeightedFrfs& curves,
                          const FrfMatrix& matrix,
                          const ModalFit& fit,
                          Index r) {
  PoleExpansion result;
  result.residues.rank = 1;
  if (matrix.references < 2 || matrix.rows.size() < 2) return result;
  const double step = step_at(fit.poles(r));
  const ModalFit both = expanded_fit(curves, fit, r);
  const Eigen::VectorXcd first = both.residues.col(r);
  const Eigen::VectorXcd second = both.residues.col(fit.poles.size());
  const Eigen::MatrixXcd D = arranged(matrix, step * (second - first));
  // What the second term can explain is no noise.
  const Noise noise = weighted_noise(curves, both, NoiseFrom::NearLines);
  result.residues = residue_rank(
      matrix, first + second, residue_variance(curves, fit, noise).col(r));
  const Index n = result.residues.rank;
  if (n < 2) return result;
  const auto& svd = result.residues.svd;
  const Eigen::VectorXd inverse = svd.singularValues().head(n).cwiseInverse();
  const Eigen::MatrixXcd K = svd.matrixU().leftCols(n).adjoint() * D *
                             svd.matrixV().leftCols(n) * inverse.asDiagonal();
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> eigen(K);
  result.apart = eigen.eigenvalues();
  result.vectors = eigen.eigenvectors();
  // D is half the step times a difference of residues that are opposite in all
  // but a little.
  const double variance_of_D =
      4.0 * step * step *
      arranged(matrix,
               residue_variance(curves, both, noise).col(r).cast<Complex>())
          .real()
          .mean();
  result.deviation =
      std::sqrt(variance_of_D * static_cast<double>(n)) * inverse.norm();
  return result;
}

}  // namespace tapfit::modal
