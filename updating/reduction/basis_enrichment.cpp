#include "updating/reduction/basis_enrichment.hpp"

#include "updating/effects/stiffness_loss.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/released_patterns.hpp"
#include "updating/structure/solve/seen_through.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;
using structure::symmetric_product;

// What is released, each degree of freedom with the base's answer to it,
//
//   psi = E - A^-1 (K + shift M) E
//
class Loose {
 public:
  Loose(const HeldBase& base, const ReleasedSystem& released)
      : base_(base), E_(units(base, released)) {
    if (E_.cols() == 0) return;
    forces_ = released.K.times(E_) + base.shift * released.M.times(E_);
  }

  [[nodiscard]] Index count() const { return E_.cols(); }
  /// u of a unit of each, dofs x count().
  [[nodiscard]] const SparseMatrix& units() const { return E_; }
  /// psi Q.
  [[nodiscard]] MatrixXd moved(const MatrixXd& Q) const {
    const Index n = base_.V.rows();
    MatrixXd psi = E_ * Q;
    psi.topRows(n) -= base_.answers.to(MatrixXd(forces_ * Q).topRows(n));
    return psi;
  }
  /// psi' (K + shift M) psi, that of unit motions in psi: the structure that is
  /// free to move feels nothing of psi.
  [[nodiscard]] MatrixXd stiffness(const MatrixXd& psi) const {
    return forces_.transpose() * psi;
  }

 private:
  static SparseMatrix units(const HeldBase& base,
                            const ReleasedSystem& released) {
    std::vector<int> loose;
    std::ranges::set_difference(
        released.active, base.motions.free, std::back_inserter(loose));
    return structure::unit_motions(base.system.T, loose, released.dofs());
  }

  const HeldBase& base_;
  SparseMatrix E_;
  SparseMatrix forces_;
};

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
  const structure::Acting elements = structure::acting(S);
  const MatrixXd U = elements.rows_of(base.V) * shares(base).asDiagonal();
  const MatrixXd SU = symmetric_product(elements.A, U);
  const MatrixXd energy = U.transpose() * SU;
  const double sign = energy.trace() < 0.0 ? -1.0 : 1.0;
  return elements.spread(SU * leading(sign * energy, little), base.V.rows());
}

// Forces where a change acts, and what the structure's answers to them move
// there: all columns of unit energy.
struct Answered {
  MatrixXd forces;
  MatrixXd moved;
};

// @param least energy that is worth it, per column
Answered answered(const HeldBase& base,
                  const structure::Acting& change,
                  const MatrixXd& forces,
                  const VectorXd& least) {
  const MatrixXd moved =
      change.rows_of(base.answers.to(change.spread(forces, base.V.rows())));
  const VectorXd energy = forces.cwiseProduct(moved).colwise().sum();
  std::vector<Index> kept;
  for (Index k = 0; k < energy.size(); ++k) {
    if (energy(k) > least(k)) kept.push_back(k);
  }
  const VectorXd unit = energy(kept).cwiseSqrt().cwiseInverse();
  return {forces(Eigen::all, kept) * unit.asDiagonal(),
          moved(Eigen::all, kept) * unit.asDiagonal()};
}

// Of the structure A as it is, and of one whose stiffness is changed by C:
//
//   A u = f,   (A + C) (u + w) = f,   w = X Y,   X' (A + C) X Y = -X' C u
//
// with X the answers of A to what is left: -C u first, then -C u - (A + C) w,
// conjugate directions, all columns at once. All these forces are where C acts.
// Source: Y. Saad, "Iterative Methods for Sparse Linear Systems", 2003, ch. 6.
MatrixXd answers_to(const HeldBase& base,
                    const structure::Acting& change,
                    const MatrixXd& forces) {
  // Of the energy of what w begins with, in the square root.
  constexpr double enough = 1e-4;
  constexpr int most_steps = 40;
  constexpr double rounding = 1e-12;  // of a unit energy
  const Answered plain = answered(
      base, change, change.rows_of(forces), VectorXd::Zero(forces.cols()));
  Answered X = answered(base,
                        change,
                        -symmetric_product(change.A, plain.moved),
                        VectorXd::Constant(plain.forces.cols(), rounding));
  const MatrixXd f = X.forces;
  MatrixXd Y(0, f.cols());
  for (int step = 0; step < most_steps && f.cols() > 0; ++step) {
    const MatrixXd all = X.forces + symmetric_product(change.A, X.moved);
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(1e-10);
    solver.compute(X.moved.transpose() * all);
    Y = solver.solve(X.moved.transpose() * f);
    const Answered next =
        answered(base,
                 change,
                 f - all * Y,
                 VectorXd::Constant(f.cols(), enough * enough));
    if (next.forces.cols() == 0) break;
    X = {join({std::move(X.forces), next.forces}),
         join({std::move(X.moved), next.moved})};
  }
  const MatrixXd both = join({plain.forces, X.forces.leftCols(Y.rows()) * Y});
  return orthonormalise(base.system.M,
                        base.answers.to(change.spread(both, base.V.rows())),
                        1e-10);
}

// What moves many released degrees of freedom: the inertia of each motion of
// the base, as far as the band moves it, and forces at the points, each as
// large as its energy is one. They are too many to be held at once, and their
// mass is what of it the base feels.
structure::ReleasedMotions released_motions(const HeldBase& base,
                                            const ReleasedSystem& released,
                                            const Loose& loose,
                                            const std::vector<int>& seen) {
  constexpr double least = 1e-2;  // of the energy at the band's top
  constexpr Index width = 64;
  const double top = std::pow(2.0 * std::numbers::pi * base.high_hz, 2);
  const VectorXd energy = base.K.cwiseMax(least * top);
  const Index count = loose.count();
  const Index motions = base.V.cols();
  MatrixXd K(count, count);
  MatrixXd felt(count, motions);  // psi' M V
  MatrixXd there(count, std::ssize(seen));
  for (Index first = 0; first < count; first += width) {
    const Index own = std::min(width, count - first);
    MatrixXd Q = MatrixXd::Zero(count, own);
    Q.middleRows(first, own).setIdentity();
    const MatrixXd psi = loose.moved(Q);
    const MatrixXd Mpsi = symmetric_product(released.M, psi);
    K.middleCols(first, own) = loose.stiffness(psi);
    felt.middleRows(first, own) =
        Mpsi.topRows(base.V.rows()).transpose() * base.V;
    there.middleRows(first, own) = psi(seen, Eigen::all).transpose();
  }
  structure::ReleasedMotions result{
      std::move(K), felt * felt.transpose(), {}, top};
  result.loads.resize(count, motions + std::ssize(seen));
  result.loads.leftCols(motions) =
      top * felt * shares(base).cwiseQuotient(energy.cwiseSqrt()).asDiagonal();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const double flexibility =
        base.V.row(seen[k]).transpose().cwiseAbs2().cwiseQuotient(energy).sum();
    result.loads.col(motions + column) =
        there.col(column) / std::sqrt(std::max(flexibility, 1e-300));
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

MatrixXd constraint_modes(const HeldBase& base,
                          const ReleasedSystem& released,
                          const std::vector<ChangeRange>& ranges,
                          const std::vector<int>& seen) {
  // Fewer are as quick as they are.
  constexpr Index many = 100;
  const Index n = base.system.dofs();
  const Loose loose(base, released);
  if (loose.count() == 0) return MatrixXd(released.dofs(), 0);
  MatrixXd patterns = MatrixXd::Identity(loose.count(), loose.count());
  if (!seen.empty() && loose.count() > many) {
    patterns =
        released_patterns(released_motions(base, released, loose, seen),
                          released_springs(loose.units(), released, ranges));
  }
  MatrixXd psi = loose.moved(patterns);
  const MatrixXd Mpsi = symmetric_product(released.M, psi);
  const MatrixXd Q =
      driven(base, Mpsi, patterns.transpose() * loose.stiffness(psi));
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
  const MatrixXd strained = strain_forces(base, lost.S);
  SparseMatrix change = -(1.0 - least) * lost.S;
  if (lost.N.size() == 0)
    return answers_to(base, structure::acting(change), strained);
  // Where its mass acts, too.
  change -= (1.0 - effects::thickness_left(least)) * lost.T + 0.0 * lost.N;
  const structure::Acting acted = structure::acting(change);
  // The answers to its forces span those to T's: with both the base had no
  // more than rounding between them.
  return join({answers_to(base, acted, strained),
               answers_to(base, acted, strain_forces(base, lost.N))});
}

MatrixXd added_modes(const HeldBase& base, const SparseMatrix& S, double most) {
  return answers_to(base, structure::acting(most * S), strain_forces(base, S));
}

}  // namespace tapfit::updating
