#include "updating/effects/added_mass.hpp"

#include "updating/structure/edit/deck_cards.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace tapfit::effects {

namespace {

bool is_rotary(const Where& where) { return where.variant == "rotary"; }

// Diagonal of the box around all grids [m].
double extent(const structure::Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const structure::Grid& grid : deck.grids) box.extend(grid.position);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace

std::vector<ParameterSpec> AddedMass::parameters(const Where& where,
                                                 const Setting& setting) const {
  // From a washer to as much as the structure itself.
  const double m = setting.mass_kg;
  std::vector<ParameterSpec> specs{{"mass_kg", 0.02 * m, 1e-5 * m, m}};
  if (is_rotary(where)) {
    // About 2 % of the structure's extent across, from a tenth to ten times.
    const double across = 0.02 * extent(*setting.deck);
    const double J = 0.02 * m * across * across;
    specs.push_back({"inertia_kg_m2", J, 1e-2 * J, 1e2 * J});
  }
  return specs;
}

// J = m r^2. An inertia alone, at next to no mass, is what the shear does that
// a bar's deck lacks.
bool AddedMass::is_plausible(const Where& where,
                             const std::vector<double>& p) const {
  if (!is_rotary(where)) return true;
  constexpr double light = 1000.0;  // kg/m^3, as plastic
  constexpr double sides = 2.0;
  const double radius = sides * std::cbrt(p[0] / light);
  return p[1] <= p[0] * radius * radius;
}

std::vector<ActedDof> AddedMass::acts_on(const Where& where,
                                         const Setting& setting,
                                         std::size_t) const {
  std::vector<ActedDof> dofs = translations(where, setting);
  if (is_rotary(where)) {
    for (int component = 4; component <= 6; ++component) {
      dofs.push_back({where.node, component, 1.0, 1});
    }
  }
  return dofs;
}

std::complex<double> AddedMass::law(std::complex<double> s,
                                    const std::vector<double>& p,
                                    std::size_t group) const {
  return s * s * p[group];
}

std::complex<double> AddedMass::law_derivative(std::complex<double> s,
                                               const std::vector<double>&,
                                               std::size_t group,
                                               std::size_t k) const {
  return group == k ? s * s : 0.0;
}

std::vector<std::string> AddedMass::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  const double inertia = is_rotary(where) ? p[1] : 0.0;
  return {point_mass_card(*setting.deck, 0, where.node, p[0], inertia)};
}

}  // namespace tapfit::effects
