#include "updating/reduction/extended_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/held_motions.hpp"
#include "updating/reduction/seen_through.hpp"
#include "updating/reduction/subspace.hpp"

#include <Eigen/Eigenvalues>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::SparseMatrix;

void turn(ReducedBase& base, const MatrixXd& Q) {
  base.rows.turn(Q);
  base.K = (Q.transpose() * base.K * Q).eval();
  for (MatrixXd& part : base.K_part) part = (Q.transpose() * part * Q).eval();
  for (MatrixXd& part : base.M_part) part = (Q.transpose() * part * Q).eval();
  for (StiffnessTerm& term : base.terms) {
    term.S = (Q.transpose() * term.S * Q).eval();
    for (MatrixXd& part : term.S_part) {
      part = (Q.transpose() * part * Q).eval();
    }
    if (term.N.size() == 0) continue;
    term.N = (Q.transpose() * term.N * Q).eval();
    for (MatrixXd& part : term.N_part) {
      part = (Q.transpose() * part * Q).eval();
    }
  }
}

namespace {

void hold(const std::vector<int>& dofs,
          const MatrixXd& V,
          const MatrixXd& R,
          ReducedBase& base) {
  if (dofs.empty()) return;
  MatrixXd rows(static_cast<Index>(dofs.size()), V.cols() + R.cols());
  rows << V(dofs, Eigen::all), R(dofs, Eigen::all);
  const MatrixXd Q = motions_without(rows);
  if (Q.cols() == 0) {
    throw InputError("nothing of the model moves in reach of the band",
                     "where it is held",
                     "hold fewer of its grids");
  }
  turn(base, Q);
  base.rows.set_at_rest(dofs);
}

}  // namespace

ReducedBase extended_base(const MatrixXd& V,
                          const ReducedBase& fixed,
                          const MatrixXd& extra,
                          const ReleasedSystem& released,
                          const std::vector<MeshFactor>& of_mesh) {
  const Index n = V.rows();
  const MatrixXd R = beyond(released.M, V, extra);
  const Index a = V.cols();
  const Index b = R.cols();
  const auto grow = [&](const MatrixXd& known, const SparseMatrix& A) {
    MatrixXd whole(a + b, a + b);
    whole.topLeftCorner(a, a) = known;
    whole.rightCols(b) = seen_through(V, R, A);
    whole.bottomLeftCorner(b, a) = whole.topRightCorner(a, b).transpose();
    return whole;
  };
  ReducedBase base;
  base.rows = fixed.rows.with(R.topRows(fixed.rows.rows()));
  base.K = grow(fixed.K, released.K);
  base.part_power = fixed.part_power;
  for (std::size_t k = 0; k < released.parts.size(); ++k) {
    base.K_part.push_back(grow(fixed.K_part[k], released.parts[k].K));
    base.M_part.push_back(grow(fixed.M_part[k], released.parts[k].M));
  }
  const auto padded = [&](const MatrixXd& known) {
    MatrixXd whole = MatrixXd::Zero(a + b, a + b);
    whole.topLeftCorner(a, a) = known;
    return whole;
  };
  for (std::size_t k = 0; k < of_mesh.size(); ++k) {
    const MatrixXd& K = fixed.K_part[released.parts.size() + k];
    SparseMatrix beyond = of_mesh[k].beyond;
    beyond.conservativeResize(released.dofs(), released.dofs());
    base.K_part.push_back(of_mesh[k].beyond.size() > 0 ? grow(K, beyond)
                                                       : padded(K));
    base.M_part.push_back(padded(fixed.M_part[released.parts.size() + k]));
  }
  const auto through = [&](const SparseMatrix& A) {
    return grow(seen_through(V, A.topLeftCorner(n, n)), A);
  };
  for (const ScaledStiffness& scaled : released.scaled) {
    StiffnessTerm& term = base.terms.emplace_back();
    term.parameter = scaled.parameter;
    term.S = through(scaled.S);
    const bool loses_mass = scaled.N.size() > 0;
    if (loses_mass) term.N = through(scaled.N);
    for (const UncertainPart& part : scaled.parts) {
      term.part_power.push_back(part.power);
      term.S_part.push_back(through(part.K));
      if (loses_mass) term.N_part.push_back(through(part.M));
    }
  }
  hold(released.held, V, R, base);
  turn(base, Eigen::SelfAdjointEigenSolver<MatrixXd>(base.K).eigenvectors());
  return base;
}

}  // namespace tapfit::updating
