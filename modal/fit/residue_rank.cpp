#include "modal/fit/residue_rank.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double second_shape = 0.15;  // singular value over the largest
constexpr double over_noise = 3.0;     // over the largest of noise alone

Index count_above(const Eigen::VectorXd& values, double noise) {
  const double least = std::max(second_shape * values(0), over_noise * noise);
  return (values.array() > least).count();
}

/// About the largest singular value of noise alone.
double largest_of_noise(const FrfMatrix& matrix,
                        const Eigen::VectorXd& variance) {
  const double mean =
      arranged(matrix, variance.cast<std::complex<double>>()).real().mean();
  return std::sqrt(mean) * (std::sqrt(static_cast<double>(matrix.rows.size())) +
                            std::sqrt(static_cast<double>(matrix.references)));
}

}  // namespace

Eigen::MatrixXcd arranged(const FrfMatrix& matrix,
                          const Eigen::VectorXcd& per_frf) {
  const auto outputs = static_cast<Index>(matrix.rows.size());
  Eigen::MatrixXcd result(outputs, matrix.references);
  for (Index o = 0; o < outputs; ++o) {
    const auto& row = matrix.rows[static_cast<std::size_t>(o)];
    for (Index i = 0; i < matrix.references; ++i) {
      result(o, i) = per_frf(row[static_cast<std::size_t>(i)]);
    }
  }
  return result;
}

Index rank_above_noise(const FrfMatrix& matrix,
                       const Eigen::MatrixXcd& residues,
                       const Eigen::VectorXd& variance) {
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(residues);
  return count_above(svd.singularValues(), largest_of_noise(matrix, variance));
}

ResidueRank residue_rank(const FrfMatrix& matrix,
                         const Eigen::VectorXcd& residue,
                         const Eigen::VectorXd& variance) {
  ResidueRank result;
  const Eigen::MatrixXcd R = arranged(matrix, residue);
  result.svd.compute(R, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double noise = largest_of_noise(matrix, variance);
  result.rank = count_above(result.svd.singularValues(), noise);
  // A single bad FRF can add to the rank, a shape is seen at many outputs.
  for (Index o = 0; o < R.rows() && result.rank > 1; ++o) {
    Eigen::MatrixXcd others(R.rows() - 1, R.cols());
    others << R.topRows(o), R.bottomRows(R.rows() - o - 1);
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(others);
    result.rank =
        std::min(result.rank, count_above(svd.singularValues(), noise));
  }
  return result;
}

bool holds_second_shape(const FrfMatrix& matrix,
                        const Eigen::VectorXcd& residue) {
  if (matrix.references < 2) return false;
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(arranged(matrix, residue));
  return count_above(svd.singularValues(), 0.0) > 1;
}

}  // namespace tapfit::modal
