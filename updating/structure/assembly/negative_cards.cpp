#include "updating/structure/assembly/negative_cards.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/listed.hpp"
#include "updating/structure/deck/card_places.hpp"
#include "updating/structure/solve/definiteness.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace tapfit::structure {

namespace {

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
    cards.push_back(fmt::format(
        "{} (K = {:.6g})",
        place(deck, {"CELAS1", "CELAS2", "CELAS3", "CELAS4", "CBUSH1D"}, e.id),
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
  if (e.matrix.size() > 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> whole(
        e.matrix, Eigen::EigenvaluesOnly);
    if (whole.eigenvalues()(0) < -1e-9 * e.matrix.norm()) return false;
  }
  return e.mass >= 0.0 && I(0) >= -1e-9 * I.cwiseAbs().maxCoeff();
}

std::vector<std::string> negative_masses(const Deck& deck) {
  std::vector<std::string> cards;
  for (const ScalarElement& e : deck.scalars) {
    if (e.mass >= 0.0) continue;
    cards.push_back(
        fmt::format("{} (M = {:.6g})",
                    place(deck, {"CMASS1", "CMASS2", "CMASS3", "CMASS4"}, e.id),
                    e.mass));
  }
  for (const PointMass& e : deck.masses) {
    if (is_positive(e)) continue;
    cards.push_back(
        fmt::format("{} (M = {:.6g}, I11 = {:.6g}, I21 = {:.6g}, "
                    "I22 = {:.6g}, I31 = {:.6g}, I32 = {:.6g}, I33 = {:.6g})",
                    place(deck, {"CONM1", "CONM2"}, e.id),
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
