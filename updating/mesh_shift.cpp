#include "updating/mesh_shift.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// MAC from which modes of two meshes are the same one.
constexpr double same_mode = 0.5;

// Translations of every grid, columns of unit length.
MatrixXd translations(const MatrixXd& rows) {
  MatrixXd result(rows.rows() / 2, rows.cols());
  for (Index g = 0; 6 * g < rows.rows(); ++g) {
    result.middleRows(3 * g, 3) = rows.middleRows(6 * g, 3);
  }
  return result.colwise().normalized();
}

}  // namespace

Eigen::VectorXd mesh_shift(const MeshModes& finer, const MeshModes& coarser) {
  const MatrixXd mac =
      (translations(finer.rows).transpose() * translations(coarser.rows))
          .cwiseAbs2();  // columns of unit length
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(finer.hz.size());
  for (Index r = 0; r < mac.rows(); ++r) {
    Index like = 0;
    if (mac.cols() == 0 || mac.row(r).maxCoeff(&like) < same_mode) continue;
    shift(r) = std::pow(2.0 * std::numbers::pi, 2) *
               (std::pow(finer.hz(r), 2) - std::pow(coarser.hz(like), 2));
  }
  return shift;
}

}  // namespace tapfit::updating
