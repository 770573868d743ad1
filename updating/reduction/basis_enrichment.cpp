#include "updating/reduction/basis_enrichment.hpp"

#include "updating/effects/stiffness_loss.hpp"
#include "updating/reduction/seen_through.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/released_patterns.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;
using structure::symmetric_product;

// u of a unit of each degree of freedom that is released: dofs x count.
SparseMatrix released_units(const HeldBase& base,
                            const ReleasedSystem& released) {
  std::vector<int> loose;
  std::ranges::set_difference(
      released.active, base.motions.free, std::back_inserter(loose));
  return structure::unit_motions(base.system.T, loose, released.dofs());
}

// How much of each vector of V the band moves: those of modes in it fully.
VectorXd shares(const HeldBase& base) {
  const double top = std::pow(2.0 * std::numbers::pi * base.high_hz, 2);
  return (top / base.K.array().cwiseMax(top)).matrix();
}

// Eigenvectors of a matrix of products, largest first, without those whose
// share is below `least` of the largest, in the square root.
MatrixXd leading(const MatrixXd& gram, double least) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
  const VectorXd& d = solver.eigenvalues();
  const Index kept =
      (d.array() > least * least * std::max(d.maxCoeff(), 0.0)).count();
  return solver.eigenvectors().rightCols(kept).rowwise().reverse();
}

// What of q inertia drives most, from rigid springs (where q is as the force on
// them) to none: the columns of Q.
// @param Mpsi M psi
// @param K psi' (K + shift M) psi
MatrixXd driven(const HeldBase& base, const MatrixXd& Mpsi, const MatrixXd& K) {
  constexpr double least = 1e-2;
  const MatrixXd forces = Mpsi.topRows(base.V.rows()).transpose() * base.V *
                          shares(base).asDiagonal();
  const MatrixXd soft = K.ldlt().solve(forces);
  const auto products = [](const MatrixXd& X) -> MatrixXd {
    return X * X.transpose() / std::max(X.squaredNorm(), 1e-300);
  };
  return leading(products(soft) + products(forces), least);
}

// Of the energy in the elements.
constexpr double little = 3e-2;

// The few patterns of force in elements that the band's modes strain.
// @param S of one sign
MatrixXd strain_forces(const HeldBase& base, const SparseMatrix& S) {
  const Acting elements = acting(S);
  const MatrixXd U = elements.rows_of(base.V) * shares(base).asDiagonal();
  const MatrixXd SU = symmetric_product(elements.A, U);
  const MatrixXd energy = U.transpose() * SU;
  const double sign = energy.trace() < 0.0 ? -1.0 : 1.0;
  return elements.spread(SU * leading(sign * energy, little), base.V.rows());
}

// Of the structure as it is and of one whose stiffness is another, to each set
// of forces.
MatrixXd answers_to(const HeldBase& base,
                    const SparseMatrix& stiffness,
                    const std::vector<MatrixXd>& forces) {
  std::optional<structure::Factor> other;
  std::vector<MatrixXd> answers;
  for (const MatrixXd& f : forces) {
    answers.push_back(f);
    if (f.cols() == 0) continue;
    if (!other) {
      other.emplace(base.motions.reduce(stiffness + base.shift * base.system.M),
                    base.answers.factor());
    }
    answers.back() = orthonormalise(
        base.system.M,
        join({base.answers.to(f),
              base.motions.expand(other->solve(base.motions.project(f)))}),
        1e-10);
  }
  return join(std::move(answers));
}

// What moves many released degrees of freedom: the inertia of each motion of
// the base, as far as the band moves it, and forces at the points, each as
// large as its energy is one.
structure::ReleasedMotions released_motions(const HeldBase& base,
                                            const MatrixXd& psi,
                                            const MatrixXd& Mpsi,
                                            const MatrixXd& K,
                                            const std::vector<int>& seen) {
  constexpr double least = 1e-2;  // of the energy at the band's top
  const double top = std::pow(2.0 * std::numbers::pi * base.high_hz, 2);
  const VectorXd energy = base.K.cwiseMax(least * top);
  const Index motions = base.V.cols();
  structure::ReleasedMotions result{K, psi.transpose() * Mpsi, {}, top};
  result.loads.resize(psi.cols(), motions + std::ssize(seen));
  result.loads.leftCols(motions) =
      top * Mpsi.topRows(base.V.rows()).transpose() * base.V *
      shares(base).cwiseQuotient(energy.cwiseSqrt()).asDiagonal();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const double flexibility =
        base.V.row(seen[k]).transpose().cwiseAbs2().cwiseQuotient(energy).sum();
    result.loads.col(motions + static_cast<Index>(k)) =
        psi.row(seen[k]).transpose() / std::sqrt(std::max(flexibility, 1e-300));
  }
  return result;
}

std::vector<structure::ReleasedSprings> released_springs(
    const SparseMatrix& units,
    const ReleasedSystem& released,
    const std::vector<ChangeRange>& ranges) {
  std::vector<structure::ReleasedSprings> springs;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const SparseMatrix Su = released.scaled[k].S * units;
    springs.push_back({MatrixXd(SparseMatrix(units.transpose() * Su)),
                       ranges[k].lower,
                       ranges[k].upper});
  }
  return springs;
}

}  // namespace

// (K + shift M) psi = 0 where the structure is free to move, so that the
// stiffness of q is that of unit motions in psi: f' psi.
MatrixXd constraint_modes(const HeldBase& base,
                          const ReleasedSystem& released,
                          const std::vector<ChangeRange>& ranges,
                          const std::vector<int>& seen) {
  // Fewer are as quick as they are.
  constexpr Index many = 100;
  const Index n = base.system.dofs();
  const SparseMatrix units = released_units(base, released);
  MatrixXd psi = units;
  if (psi.cols() == 0) return psi;
  const SparseMatrix forces =
      *released.K * units + base.shift * (*released.M * units);
  psi.topRows(n) -= base.answers.to(MatrixXd(forces).topRows(n));
  MatrixXd Mpsi = symmetric_product(*released.M, psi);
  MatrixXd K = forces.transpose() * psi;
  if (!seen.empty() && psi.cols() > many) {
    const MatrixXd patterns =
        released_patterns(released_motions(base, psi, Mpsi, K, seen),
                          released_springs(units, released, ranges));
    psi = (psi * patterns).eval();
    Mpsi = (Mpsi * patterns).eval();
    K = (patterns.transpose() * K * patterns).eval();
  }
  const MatrixXd Q = driven(base, Mpsi, K);
  std::vector<MatrixXd> both;
  both.push_back(std::move(psi));
  both.push_back(base.answers.to(Mpsi.topRows(n) * Q));
  return join(std::move(both));
}

// u = V a + (1 - p) (A - (1 - p) S)^-1 S V a: patterns of the elements' own
// forces are few, and between its two ends the answer to one runs smoothly.
MatrixXd loss_modes(const HeldBase& base,
                    const LostMatrices& lost,
                    double least) {
  std::vector<MatrixXd> forces = {strain_forces(base, lost.S)};
  SparseMatrix K = base.system.K - (1.0 - least) * lost.S;
  if (lost.N.size() > 0) {
    K -= (1.0 - effects::thickness_left(least)) * lost.T;
    // The answers to its forces span those to T's: with both the base had no
    // more than rounding between them.
    forces.push_back(strain_forces(base, lost.N));
  }
  return answers_to(base, K, forces);
}

MatrixXd added_modes(const HeldBase& base, const SparseMatrix& S, double most) {
  return answers_to(base, base.system.K + most * S, {strain_forces(base, S)});
}

}  // namespace tapfit::updating
