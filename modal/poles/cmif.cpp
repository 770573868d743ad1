#include "modal/poles/cmif.hpp"

#include "modal/poles/frf_matrix.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace tapfit::modal {

Eigen::VectorXd summed_frf(const signal::FrfSet& frfs) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(frfs.lines());
  for (const signal::Frf& frf : frfs.frfs) sum += frf.H.cwiseAbs2();
  if (frfs.frfs.empty()) return sum;
  return (sum / static_cast<double>(frfs.frfs.size())).cwiseSqrt();
}

Eigen::MatrixXd cmif(const signal::FrfSet& frfs) {
  std::vector<std::string> warnings;
  const WeightedFrfs curves = prepare_frfs(frfs, warnings);
  const FrfMatrix matrix = arrange_frfs(curves);
  const auto outputs = static_cast<Eigen::Index>(matrix.rows.size());
  const Eigen::Index values = std::min(outputs, matrix.references);
  const Eigen::Index skipped = frfs.lines() - curves.lines();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(frfs.lines(), values);
  Eigen::MatrixXcd H(outputs, matrix.references);
  for (Eigen::Index k = 0; k < curves.lines(); ++k) {
    for (Eigen::Index o = 0; o < outputs; ++o) {
      const auto& row = matrix.rows[static_cast<std::size_t>(o)];
      for (Eigen::Index i = 0; i < matrix.references; ++i) {
        H(o, i) = curves.H(k, row[static_cast<std::size_t>(i)]);
      }
    }
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(H);
    result.row(k + skipped) = svd.singularValues().head(values).transpose();
  }
  return result;
}

}  // namespace tapfit::modal
