// A mass fixed to one grid: Delta Z = s^2 m on its three translations. The
// variant "rotary" has an inertia as well, s^2 J on its three rotations: a body
// that is large against the wavelength, or stands off.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace tapfit::effects {
namespace {

bool is_rotary(const Location& where) { return where.variant == "rotary"; }

// Diagonal of the box around all grids [m].
double extent(const structure::Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const structure::Grid& grid : deck.grids) box.extend(grid.position);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

class AddedMass final : public PointEffect {
 public:
  AddedMass()
      : PointEffect({.name = "added-mass",
                     .words = "added mass",
                     .sits = Sits::AtGrid,
                     .law = Law::Mass,
                     .forms = {"rotary"}}) {}

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // From a washer to as much as the structure itself.
    const double m = context.mass_kg;
    std::vector<ParameterSpec> specs{{"mass_kg", 0.02 * m, 1e-5 * m, m}};
    if (is_rotary(where)) {
      // About 2 % of the structure's extent across, from a tenth to ten times.
      const double across = 0.02 * extent(*context.deck);
      const double J = 0.02 * m * across * across;
      specs.push_back({"inertia_kg_m2", J, 1e-2 * J, 1e2 * J});
    }
    return specs;
  }

  // Where it turns, J = m r^2, r not farther out than twice the side of a cube
  // of plastic. An inertia alone, at next to no mass, is what the shear does
  // that a bar's deck lacks.
  bool is_plausible(const Location& where,
                    const std::vector<double>& p) const override {
    if (!is_rotary(where)) return true;
    constexpr double light = 1000.0;  // kg/m^3, as plastic
    constexpr double sides = 2.0;
    const double radius = sides * std::cbrt(p[0] / light);
    return p[1] <= p[0] * radius * radius;
  }

  std::vector<InterfaceDof> interface_dofs(const Location& where,
                                           const TestContext& context,
                                           std::size_t) const override {
    std::vector<InterfaceDof> dofs = translations(where, context);
    if (is_rotary(where)) {
      for (int component = 4; component <= 6; ++component) {
        dofs.push_back({where.node, component, 1.0, 1});
      }
    }
    return dofs;
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    const double inertia = is_rotary(where) ? p[1] : 0.0;
    return {point_mass_card(*context.deck, 0, where.node, p[0], inertia)};
  }
};

}  // namespace

const Effect& added_mass() {
  static const AddedMass effect;
  return effect;
}

}  // namespace tapfit::effects
