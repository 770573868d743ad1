#include "updating/structure/checks/number_scales.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/deck/card_places.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

namespace tapfit::structure {
namespace {

// Magnitudes; zero is judged elsewhere.
struct Scale {
  double least;
  double largest;
};

// Wide enough for SI, millimetres and tonnes, inches and pounds, and for the
// huge and tiny values that stand for rigid and for absent parts.
namespace scales {
constexpr Scale length{0.0, 1e9};
constexpr Scale modulus{1e-9, 1e20};
constexpr Scale density{1e-30, 1e12};
constexpr Scale area{1e-30, 1e15};
constexpr Scale inertia{1e-40, 1e20};  // second moments of area, too
constexpr Scale ratio{0.0, 1e12};      // of a section to a solid one
constexpr Scale mass{0.0, 1e15};
constexpr Scale spring{1e-30, 1e20};
constexpr Scale unit_factor{1e-12, 1e12};  // WTMASS
}  // namespace scales

using PlaceOf = std::function<std::string()>;

void check_scale(const PlaceOf& place,
                 const char* field,
                 double value,
                 Scale scale) {
  const double size = std::abs(value);
  if (size == 0.0 || (size >= scale.least && size <= scale.largest)) return;
  throw InputError(
      fmt::format("{} is {:.6g}, of no structure in any units", field, value),
      place(),
      scale.least > 0.0
          ? fmt::format("Correct the field; from {:g} to {:g} is plausible.",
                        scale.least,
                        scale.largest)
          : fmt::format("Correct the field; up to {:g} is plausible.",
                        scale.largest));
}

void check_material_scales(const Deck& deck) {
  for (const auto& [id, m] : deck.materials) {
    const PlaceOf place = [&deck, &m = m] {
      return card_place(deck, m.where, fmt::format("material {}", m.id));
    };
    check_scale(place, m.orthotropic ? "E1" : "E", m.E, scales::modulus);
    check_scale(place, m.orthotropic ? "G12" : "G", m.G, scales::modulus);
    check_scale(place, "E2", m.E2, scales::modulus);
    check_scale(place, "G1z", m.G1z, scales::modulus);
    check_scale(place, "G2z", m.G2z, scales::modulus);
    check_scale(place, "RHO", m.rho, scales::density);
  }
}

void check_shell_properties(const Deck& deck) {
  for (const auto& [id, p] : deck.shell_properties) {
    const PlaceOf place = [&deck, &p = p] {
      return card_place(deck, p.where, fmt::format("PSHELL {}", p.id));
    };
    check_scale(place, "T", p.thickness, {1e-15, scales::length.largest});
    check_scale(place, "12I/T**3", p.bending_ratio, scales::ratio);
    check_scale(place, "TS/T", p.shear_ratio, scales::ratio);
    check_scale(place, "NSM", p.nonstructural, scales::mass);
  }
}

void check_bar_properties(const Deck& deck) {
  for (const auto& [id, p] : deck.bar_properties) {
    const PlaceOf place = [&deck, &p = p] {
      return card_place(deck, p.where, fmt::format("PBAR {}", p.id));
    };
    check_scale(place, "A", p.area, scales::area);
    check_scale(place, "I1", p.I1, scales::inertia);
    check_scale(place, "I2", p.I2, scales::inertia);
    check_scale(place, "I12", p.I12, {0.0, scales::inertia.largest});
    check_scale(place, "J", p.J, scales::inertia);
    check_scale(place, "NSM", p.nonstructural, scales::mass);
    check_scale(place, "K1", p.K1, scales::ratio);
    check_scale(place, "K2", p.K2, scales::ratio);
  }
  for (const auto& [id, p] : deck.rod_properties) {
    const PlaceOf place = [&deck, &p = p] {
      return card_place(deck, p.where, fmt::format("PROD {}", p.id));
    };
    check_scale(place, "A", p.area, scales::area);
    check_scale(place, "J", p.J, scales::inertia);
    check_scale(place, "NSM", p.nonstructural, scales::mass);
  }
}

void check_point_elements(const Deck& deck) {
  for (const PointMass& m : deck.masses) {
    const PlaceOf place = [&] { return card_where(deck, {"CONM2"}, m.id); };
    check_scale(place, "M", m.mass, scales::mass);
    check_scale(place, "X", m.offset.cwiseAbs().maxCoeff(), scales::length);
    check_scale(place,
                "I",
                m.inertia.cwiseAbs().maxCoeff(),
                {0.0, scales::inertia.largest});
  }
  for (const ScalarElement& e : deck.scalars) {
    const PlaceOf place = [&] {
      return card_where(
          deck, {"CELAS1", "CELAS2", "CDAMP1", "CDAMP2", "CMASS2"}, e.id);
    };
    check_scale(place, "K", e.stiffness, scales::spring);
    check_scale(place, "B", e.damping, {0.0, scales::spring.largest});
    check_scale(place, "M", e.mass, scales::mass);
  }
  for (const Bush& e : deck.bushes) {
    const PlaceOf place = [&] { return card_where(deck, {"CBUSH"}, e.id); };
    for (const double k : e.stiffness)
      check_scale(place, "K", k, scales::spring);
    for (const double b : e.damping) {
      check_scale(place, "B", b, {0.0, scales::spring.largest});
    }
  }
}

}  // namespace

void check_number_scales(const Deck& deck) {
  for (const Grid& grid : deck.grids) {
    check_scale([&] { return grid_place(deck, grid.id); },
                "X",
                grid.position.cwiseAbs().maxCoeff(),
                scales::length);
  }
  check_material_scales(deck);
  check_shell_properties(deck);
  check_bar_properties(deck);
  check_point_elements(deck);
  check_scale([&] { return deck.path.filename().string() + ": PARAM"; },
              "WTMASS",
              deck.weight_to_mass,
              scales::unit_factor);
}

}  // namespace tapfit::structure
