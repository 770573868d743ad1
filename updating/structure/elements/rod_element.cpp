// CROD and CONROD: axial force and torsion. The coupled mass is the mean of
// the consistent and the lumped one, as in Nastran: its axial waves have an
// error of fourth order in the length instead of second.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace tapfit::structure {

ElementMatrices rod_matrices(const Deck& deck, const Rod& rod) {
  const RodProperty& p = deck.rod_properties.at(rod.property);
  const Material& m = deck.materials.at(p.material);
  const Eigen::Vector3d side =
      deck.grid(rod.grids[1]).position - deck.grid(rod.grids[0]).position;
  const double L = side.norm();
  if (!(L > 0.0)) {
    throw InputError("the rod has no length",
                     card_place(deck, rod.where, fmt::format("rod {}", rod.id)),
                     "Give two grids at different places.");
  }
  const Eigen::Matrix3d along = side * side.transpose() / (L * L);
  const double mass = (m.rho * p.area + p.nonstructural) * L;
  const double same = deck.coupled_mass ? mass * 5.0 / 12.0 : mass / 2.0;
  const double other = deck.coupled_mass ? mass / 12.0 : 0.0;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(12, 12);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(12, 12);
  for (Eigen::Index a = 0; a < 12; a += 6) {
    for (Eigen::Index b = 0; b < 12; b += 6) {
      const double sign = a == b ? 1.0 : -1.0;
      K.block<3, 3>(a, b) = sign * m.E * p.area / L * along;
      K.block<3, 3>(a + 3, b + 3) = sign * m.G * p.J / L * along;
      M.block<3, 3>(a, b).diagonal().setConstant(a == b ? same : other);
    }
  }
  return {{rod.grids[0], rod.grids[1]}, K, M};
}

}  // namespace tapfit::structure
