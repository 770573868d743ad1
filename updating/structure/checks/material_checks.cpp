#include "updating/structure/checks/material_checks.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/listed.hpp"

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

std::vector<std::string> material_unit_warnings(const Deck& deck) {
  // From soft foam to beyond diamond.
  constexpr double softest = 1e3;  // [Pa]
  constexpr double stiffest = 1e13;
  constexpr double slowest = 1.0;  // [m/s]
  constexpr double fastest = 3e4;
  std::vector<std::string> texts;
  if (deck.given) return texts;
  for (const auto& [id, m] : deck.materials) {
    if (m.E <= 0.0) continue;
    const bool odd_modulus = m.E < softest || m.E > stiffest;
    const double rho = m.rho * deck.weight_to_mass;
    const double speed = rho > 0.0 ? std::sqrt(m.E / rho) : slowest;
    if (!odd_modulus && speed >= slowest && speed <= fastest) continue;
    texts.push_back(fmt::format(
        "{}: E = {:.4g} Pa with a density of {:.4g} kg/m^3 is no solid's; "
        "check the deck's \"units\" in test.json, \"SI\", \"mm-t-s\" "
        "(millimetres, tonnes, newtons) or \"in-lbf-s\" (inches, "
        "pounds-force)",
        place_of(deck, m),
        m.E,
        rho));
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
