#include "updating/structure/checks/unit_checks.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/listed.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>

namespace tapfit::structure {
namespace {

std::string place_of(const Deck& deck, const Material& m) {
  return card_place(
      deck,
      m.where,
      fmt::format("{} {}", m.orthotropic ? "MAT8" : "MAT1", m.id));
}

}  // namespace

bool is_solid(double modulus, double density) {
  constexpr double softest = 1e3;  // [Pa]
  constexpr double stiffest = 1e13;
  constexpr double slowest = 5.0;  // [m/s]
  constexpr double fastest = 3e4;
  constexpr double dense = 2500.0;         // [kg/m^3], above all polymers
  constexpr double slowest_dense = 300.0;  // [m/s]
  if (modulus < softest || modulus > stiffest) return false;
  if (density <= 0.0) return true;
  const double speed = std::sqrt(modulus / density);
  return speed <= fastest &&
         speed >= (density > dense ? slowest_dense : slowest);
}

double size_of(const Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const Grid& grid : deck.grids) {
    if (!grid.scalar) box.extend(grid.position);
  }
  return box.isEmpty() ? 0.0 : box.sizes().norm();
}

bool is_too_long(double length, double size) {
  constexpr double most = 0.5;
  return length > most * size;
}

std::vector<std::string> unit_warnings(const Deck& deck) {
  std::vector<std::string> texts;
  if (deck.given) return texts;
  for (const auto& [id, m] : deck.materials) {
    if (m.E <= 0.0) continue;
    const double rho = m.rho * deck.weight_to_mass;
    if (is_solid(m.E, rho)) continue;
    texts.push_back(fmt::format(
        "{}: E = {:.4g} Pa with a density of {:.4g} kg/m^3 is no solid's; "
        "check the deck's \"units\" in test.json, \"SI\", \"mm-t-s\" "
        "(millimetres, tonnes, newtons) or \"in-lbf-s\" (inches, "
        "pounds-force)",
        place_of(deck, m),
        m.E,
        rho));
  }
  const double size = size_of(deck);
  for (const auto& [id, p] : deck.shell_properties) {
    if (!is_too_long(p.thickness, size)) continue;
    texts.push_back(fmt::format(
        "{}: a thickness of {:.4g} m is no shell's in a structure of {:.4g} m; "
        "check its unit",
        card_place(deck, p.where, fmt::format("PSHELL {}", id)),
        p.thickness,
        size));
  }
  return texts;
}

InputError no_density(const Deck& deck, const std::string& what) {
  std::vector<std::string> without;
  for (const auto& [id, m] : deck.materials) {
    if (m.rho == 0.0) without.push_back(place_of(deck, m));
  }
  return InputError(
      what,
      without.empty() ? deck.path.filename().string() : listed(without),
      "Give the materials a density (RHO) or add CONM2.");
}

}  // namespace tapfit::structure
