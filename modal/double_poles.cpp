#include "modal/double_poles.hpp"

#include "modal/shape_uncertainty.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kSecondShape = 0.15;  // as in split_poles
constexpr double kOverNoise = 3.0;     // over the largest of noise alone
constexpr double kStep = 1e-2;         // half bandwidths, for the derivative

/// Outputs x references.
template <typename Vector>
auto arranged(const FrfMatrix& matrix, const Vector& per_frf) {
  using Scalar = typename Vector::Scalar;
  const auto outputs = static_cast<Index>(matrix.rows.size());
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> result(
      outputs, matrix.references);
  for (Index o = 0; o < outputs; ++o) {
    const auto& row = matrix.rows[static_cast<std::size_t>(o)];
    for (Index i = 0; i < matrix.references; ++i) {
      result(o, i) = per_frf(row[static_cast<std::size_t>(i)]);
    }
  }
  return result;
}

}  // namespace

Eigen::VectorXcd poles_in_place_of(const Curves& curves,
                                   const FrfMatrix& matrix,
                                   const ModalFit& fit,
                                   Index r) {
  const Complex pole = fit.poles(r);
  const auto outputs = static_cast<Index>(matrix.rows.size());
  Eigen::VectorXcd alone(1);
  alone << pole;
  if (matrix.references < 2 || outputs < 2) return alone;
  // M and D from two poles at a small distance.
  const double step = -kStep * pole.real();
  Eigen::VectorXcd poles(fit.poles.size() + 1);
  poles << fit.poles, pole + step;
  poles(r) = pole - step;
  const ModalFit both = fit_residues(curves, poles);
  const Eigen::VectorXcd first = both.residues.col(r);
  const Eigen::VectorXcd second = both.residues.col(poles.size() - 1);
  const Eigen::MatrixXcd M = arranged(matrix, (first + second).eval());
  const Eigen::MatrixXcd D = arranged(matrix, (step * (second - first)).eval());
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(
      M, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd values = svd.singularValues();
  // About the largest singular value of noise alone; what the second term can
  // explain is none.
  ModalFit explained = fit;
  explained.H = both.H;
  const Eigen::VectorXd variance = residue_variance(curves, explained).col(r);
  const double noise = std::sqrt(arranged(matrix, variance).mean()) *
                       (std::sqrt(static_cast<double>(outputs)) +
                        std::sqrt(static_cast<double>(matrix.references)));
  const double least = std::max(kSecondShape * values(0), kOverNoise * noise);
  const Index n = (values.array() > least).count();
  if (n < 2) return alone;
  const Eigen::MatrixXcd inner = svd.matrixU().leftCols(n).adjoint() * D *
                                 svd.matrixV().leftCols(n) *
                                 values.head(n).cwiseInverse().asDiagonal();
  const Eigen::VectorXcd apart =
      Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(inner, false).eigenvalues();
  return (apart.array() + pole).matrix();
}

}  // namespace tapfit::modal
