#include "updating/reduction/extended_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/held_motions.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/seen_through.hpp"

#include <Eigen/Eigenvalues>

#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::BorderedMatrix;
using structure::SparseMatrix;

namespace {

// Coordinates in which what is held stays at rest.
MatrixXd coordinates_left(const std::vector<int>& dofs,
                          const MatrixXd& V,
                          const MatrixXd& R) {
  MatrixXd rows(static_cast<Index>(dofs.size()), V.cols() + R.cols());
  rows << V(dofs, Eigen::all), R(dofs, Eigen::all);
  MatrixXd Q = motions_without(rows);
  if (Q.cols() == 0) {
    throw InputError("nothing of the model moves in reach of the band",
                     "where it is held",
                     "hold fewer of its grids");
  }
  return Q;
}

}  // namespace

ReducedBase extended_base(const MatrixXd& V,
                          const ReducedBase& fixed,
                          MatrixXd extra,
                          const ReleasedSystem& released,
                          const std::vector<CorrectionPart>& corrections) {
  const MatrixXd R = m_orthogonal_complement(released.M, V, std::move(extra));
  const Index a = V.cols();
  const Index b = R.cols();
  const auto grow = [&](const MatrixXd& known, const BorderedMatrix& A) {
    MatrixXd whole = MatrixXd::Zero(a + b, a + b);
    whole.topLeftCorner(a, a) = known;
    if (A.is_zero()) return whole;
    whole.rightCols(b) = structure::seen_through(V, R, A);
    whole.bottomLeftCorner(b, a) = whole.topRightCorner(a, b).transpose();
    return whole;
  };
  const std::vector<ReleasedPart>& parts = released.parts;
  ReducedBase base;
  base.rows = fixed.rows.with(R.topRows(fixed.rows.rows()));
  base.K = grow(fixed.K, released.K);
  base.part_power = fixed.part_power;
  base.corrections = fixed.corrections;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    base.K_part.push_back(grow(fixed.K_part[k], parts[k].K));
    base.M_part.push_back(grow(fixed.M_part[k], parts[k].M));
  }
  const std::vector<ReleasedForm>& forms = released.forms;
  const std::size_t others = corrections.size() - forms.size();
  const BorderedMatrix nothing;
  for (std::size_t k = 0; k < corrections.size(); ++k) {
    const std::size_t part = parts.size() + k;
    base.K_part.push_back(grow(fixed.K_part[part], corrections[k].beyond));
    base.M_part.push_back(
        grow(fixed.M_part[part], k < others ? nothing : forms[k - others].M));
  }
  MatrixXd left;
  if (!released.held.empty()) {
    left = coordinates_left(released.held, V, R);
    base.turn(left);
    base.rows.set_at_rest(released.held);
  }
  const auto through = [&](const SparseMatrix& A) {
    MatrixXd seen = structure::seen_through_all(V, R, A);
    return left.size() == 0 ? seen : MatrixXd(left.transpose() * seen * left);
  };
  for (const ScaledStiffness& scaled : released.scaled) {
    StiffnessTerm& term = base.terms.emplace_back();
    term.parameter = scaled.parameter;
    term.S = through(scaled.S);
    for (const UncertainPart& part : scaled.parts) {
      term.part_power.push_back(part.power);
      term.S_part.push_back(through(part.K));
    }
    if (!scaled.is_thinned()) continue;
    term.T = through(scaled.thickness.K);
    term.N = through(scaled.thickness.M);
    for (const UncertainPart& part : scaled.thickness.parts) {
      term.T_part.push_back(through(part.K));
      term.N_part.push_back(through(part.M));
    }
  }
  if (base.terms.empty()) {
    base.turn(Eigen::SelfAdjointEigenSolver<MatrixXd>(base.K).eigenvectors());
  }
  return base;
}

}  // namespace tapfit::updating
