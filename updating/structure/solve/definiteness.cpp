#include "updating/structure/solve/definiteness.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/listed.hpp"
#include "updating/structure/deck/card_places.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::string place(const Deck& deck,
                  const std::set<std::string>& names,
                  int id) {
  const std::string where = card_where(deck, names, id);
  return where.empty() ? fmt::format("{} {}", *names.begin(), id) : where;
}

std::vector<std::string> negative_springs(const Deck& deck) {
  std::vector<std::string> cards;
  for (const ScalarElement& e : deck.scalars) {
    if (e.stiffness >= 0.0) continue;
    cards.push_back(fmt::format("{} (K = {:.6g})",
                                place(deck, {"CELAS1", "CELAS2"}, e.id),
                                e.stiffness));
  }
  for (const Bush& e : deck.bushes) {
    const double least =
        *std::min_element(e.stiffness.begin(), e.stiffness.end());
    if (least >= 0.0) continue;
    cards.push_back(
        fmt::format("{} (K = {:.6g})", place(deck, {"CBUSH"}, e.id), least));
  }
  return cards;
}

bool is_positive(const PointMass& e) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      e.inertia, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d I = solver.eigenvalues();
  return e.mass >= 0.0 && I(0) >= -1e-9 * I.cwiseAbs().maxCoeff();
}

std::vector<std::string> negative_masses(const Deck& deck) {
  std::vector<std::string> cards;
  for (const ScalarElement& e : deck.scalars) {
    if (e.mass >= 0.0) continue;
    cards.push_back(
        fmt::format("{} (M = {:.6g})", place(deck, {"CMASS2"}, e.id), e.mass));
  }
  for (const PointMass& e : deck.masses) {
    if (is_positive(e)) continue;
    cards.push_back(
        fmt::format("{} (M = {:.6g}, I11 = {:.6g}, I21 = {:.6g}, "
                    "I22 = {:.6g}, I31 = {:.6g}, I32 = {:.6g}, I33 = {:.6g})",
                    place(deck, {"CONM2"}, e.id),
                    e.mass,
                    e.inertia(0, 0),
                    // As the card has them: products with a minus.
                    -e.inertia(1, 0),
                    e.inertia(1, 1),
                    -e.inertia(2, 0),
                    -e.inertia(2, 1),
                    e.inertia(2, 2)));
  }
  return cards;
}

void refuse(const Deck& deck,
            const std::vector<std::string>& cards,
            const char* kind) {
  throw InputError(
      fmt::format("the {} is not positive: some motion has less than none of "
                  "it, by {}",
                  kind,
                  listed(cards)),
      deck.path.filename().string(),
      "Give these cards values above zero, or such that they take away less "
      "than there is.");
}

}  // namespace

bool is_indefinite(const SparseMatrix& A) {
  constexpr double kAllowed = 1e-9;
  // Below this share of the largest diagonal entry, entries may be rounding.
  constexpr double kSmall = 1e-5;
  if (A.rows() == 0) return false;
  const VectorXd size = A.diagonal().cwiseAbs();
  const double least = kSmall * size.maxCoeff();
  if (!(least > 0.0)) return A.norm() > 0.0;
  const VectorXd scale = size.cwiseMax(least).cwiseSqrt().cwiseInverse();
  SparseMatrix unit = scale.asDiagonal() * A * scale.asDiagonal();
  SparseMatrix allowed(A.rows(), A.cols());
  allowed.setIdentity();
  unit += kAllowed * allowed;
  try {
    return Factor(unit).pivots().minCoeff() < 0.0;
  } catch (const SingularMatrix&) {
    return false;  // not proven
  }
}

void refuse_indefinite(const SparseMatrix& K, const SparseMatrix& M) {
  const bool stiffness = is_indefinite(K);
  if (!stiffness && !is_indefinite(M)) return;
  throw InputError(fmt::format("the {} is not positive: some motion has "
                               "negative energy",
                               stiffness ? "stiffness" : "mass"),
                   stiffness ? "stiffness matrix" : "mass matrix",
                   "Look for springs, elements or masses below zero.");
}

void refuse_negative_cards(const Deck& deck, const System& system) {
  const auto any = [&](auto below_zero) {
    return std::any_of(deck.scalars.begin(), deck.scalars.end(), below_zero);
  };
  const bool springs =
      any([](const ScalarElement& e) { return e.stiffness < 0.0; }) ||
      std::any_of(deck.bushes.begin(), deck.bushes.end(), [](const Bush& e) {
        return *std::min_element(e.stiffness.begin(), e.stiffness.end()) < 0.0;
      });
  const bool masses =
      any([](const ScalarElement& e) { return e.mass < 0.0; }) ||
      !std::all_of(deck.masses.begin(), deck.masses.end(), is_positive);
  if (!springs && !masses) return;
  const FreeMotions motions = free_motions(system);
  if (springs && is_indefinite(motions.reduce(system.K))) {
    refuse(deck, negative_springs(deck), "stiffness");
  }
  if (masses && is_indefinite(motions.reduce(system.M))) {
    refuse(deck, negative_masses(deck), "mass");
  }
}

}  // namespace tapfit::structure
