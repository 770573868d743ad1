// Small changes of a shape and of the products that FRFs know of it,
//
//   P_ab = phi_a phi_b,   dP = J dphi,   row of FRF a / b: phi_b at a, phi_a
//                                        at b
//
// by weighted least squares. A row of J has two entries and the equations of a
// point hold only its neighbours, so that J' W^2 J is factored as a sparse
// matrix, in units of its diagonal D:
//
//   (D^-1/2 J' W^2 J D^-1/2 + eps) x = ...
//
// where eps keeps what no FRF fixes (the scale, a point that none reaches) at
// rest.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <complex>
#include <utility>
#include <vector>

namespace tapfit::modal {

/// Points of each FRF; -1 for one that is left out, with its FRF.
using Edges = std::vector<std::pair<Eigen::Index, Eigen::Index>>;

class ShapeEquations {
 public:
  /// @param phi n_points
  /// @param weight of each FRF, w, n_frfs; 0 leaves it out
  ShapeEquations(Edges edges,
                 const Eigen::VectorXcd& phi,
                 const Eigen::VectorXd& weight);

  /// The change of phi that explains that of the products best.
  ///
  /// @param dP n_frfs
  [[nodiscard]] Eigen::VectorXcd solve(const Eigen::VectorXcd& dP) const;

  /// Standard deviation of each value of phi where the products have 1 / w;
  /// 0 for points without an equation.
  [[nodiscard]] Eigen::VectorXd deviations() const;

  /// Points with an equation.
  [[nodiscard]] Eigen::Index known() const;

 private:
  Edges edges_;
  Eigen::VectorXcd phi_;
  Eigen::VectorXd weight_;
  Eigen::VectorXd unit_;  ///< D^-1/2; 0 where D is
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<std::complex<double>>> factor_;
};

}  // namespace tapfit::modal
