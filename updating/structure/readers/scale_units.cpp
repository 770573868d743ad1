#include "updating/structure/readers/scale_units.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/model_units.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace tapfit::structure {
namespace {

struct Units : ModelUnits {
  [[nodiscard]] double area() const { return length * length; }
  [[nodiscard]] double area_moment() const { return area() * area(); }
  [[nodiscard]] double inertia() const { return mass * area(); }
  [[nodiscard]] double stress() const { return mass / length; }
  [[nodiscard]] double density() const { return mass / (area() * length); }
};

void scale_elements(Deck& deck, const Units& to) {
  for (Grid& grid : deck.grids) grid.position *= to.length;
  for (auto& [id, system] : deck.systems) system.origin *= to.length;
  for (Bar& bar : deck.bars) {
    for (Eigen::Vector3d& offset : bar.offsets) offset *= to.length;
  }
  for (Shell& shell : deck.shells) {
    shell.offset *= to.length;
    shell.thickness *= to.length;
  }
  for (Relation& e : deck.relations) {
    for (RelationTerm& term : e.terms) {
      // A displacement is a length, a turn is none.
      if (e.component < 4) term.factor *= to.length;
      if (term.component < 4) term.factor /= to.length;
    }
  }
  for (std::vector<MatrixTerm>* terms :
       {&deck.stiffness_terms, &deck.mass_terms}) {
    for (MatrixTerm& term : *terms) {
      term.value *= to.inertia();
      for (const int component : term.components) {
        if (component < 4) term.value /= to.length;
      }
    }
  }
  for (PointMass& mass : deck.masses) {
    for (Eigen::Index i = 0; i < mass.matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < mass.matrix.cols(); ++j) {
        mass.matrix(i, j) *= to.mass * std::pow(to.length, i / 3 + j / 3);
      }
    }
    mass.mass *= to.mass;
    mass.offset *= to.length;
    mass.inertia *= to.inertia();
  }
  // N/mm is t/s^2. A rotation takes a length for each of its two ends.
  for (ScalarElement& e : deck.scalars) {
    double factor = to.mass;
    int rotations = 0;
    int ends = 0;
    for (std::size_t end = 0; end < 2; ++end) {
      if (e.grids[end] == 0) continue;
      ++ends;
      if (e.components[end] > 3) ++rotations;
    }
    factor *= std::pow(to.length, 2.0 * rotations / ends);
    e.stiffness *= factor;
    e.damping *= factor;
    e.mass *= factor;
  }
  for (Bush& e : deck.bushes) {
    for (Eigen::Vector3d& arm : e.arms) arm *= to.length;
    for (std::size_t c = 0; c < 6; ++c) {
      const double factor = c < 3 ? to.mass : to.inertia();
      e.stiffness[c] *= factor;
      e.damping[c] *= factor;
    }
  }
}

void scale_properties(Deck& deck, const Units& to) {
  for (auto& [id, p] : deck.shell_properties) {
    p.thickness *= to.length;
    p.bottom *= to.length;
    for (Ply& ply : p.plies) ply.thickness *= to.length;
    p.nonstructural *= to.mass / to.area();
  }
  for (auto& [id, p] : deck.bar_properties) {
    p.area *= to.area();
    for (double* I : {&p.I1, &p.I2, &p.I12, &p.J}) *I *= to.area_moment();
    p.nonstructural *= to.mass / to.length;
    p.nonstructural_inertia *= to.mass * to.length;
    p.neutral *= to.length;
    p.nonstructural_at *= to.length;
  }
  for (auto& [id, p] : deck.rod_properties) {
    p.area *= to.area();
    p.J *= to.area_moment();
    p.nonstructural *= to.mass / to.length;
  }
  for (auto& [id, m] : deck.materials) {
    for (double* E : {&m.E, &m.E2, &m.G, &m.G1z, &m.G2z}) *E *= to.stress();
    m.plane *= to.stress();
    m.solid *= to.stress();
    m.rho *= to.density();
  }
}

// x' A x is an energy (over s^2 for a mass); a rotation has no unit.
SparseMatrix scaled(const SparseMatrix& A, const Units& to) {
  Eigen::VectorXd per(A.rows());
  for (Eigen::Index i = 0; i < per.size(); ++i) {
    per(i) = i % 6 < 3 ? 1.0 / to.length : 1.0;
  }
  const SparseMatrix turned = per.asDiagonal() * A * per.asDiagonal();
  return to.inertia() * turned;
}

}  // namespace

void scale_to_si(Deck& deck, const std::string& units) {
  if (units == "SI" || units.empty()) return;
  const std::optional<ModelUnits> known = model_units(units);
  if (!known) {
    throw InputError(fmt::format("the units \"{}\" are not known", units),
                     "test.json: units",
                     "Use \"SI\", \"mm-t-s\" or \"in-lbf-s\".");
  }
  const Units to{*known};
  scale_elements(deck, to);
  if (!deck.given) {
    scale_properties(deck, to);
  } else {
    deck.given = std::make_shared<const GivenMatrices>(
        GivenMatrices{scaled(deck.given->K, to), scaled(deck.given->M, to)});
  }
  deck.file_length_m = to.length;
  deck.file_mass_kg = to.mass;
}

}  // namespace tapfit::structure
