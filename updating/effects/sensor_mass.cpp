#include "updating/effects/sensor_mass.hpp"

#include "updating/effects/point_effect.hpp"
#include "updating/effects/sensor_channels.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tapfit::effects {
namespace {

// Index of the mass of a channel: its own, or the shared one.
std::size_t group_of(const Where& where, std::size_t position) {
  return where.variant == "each" ? position : 0;
}

// Inertia of a kilogram about the axes of the surface [m^2]: the middle of an
// accelerometer on its mount is some 10 mm above a plate's middle. Left free it
// would stand for whatever a deck lacks in its high modes.
constexpr double height = 0.01;
constexpr double inertia = height * height;

}  // namespace

std::vector<Where> SensorMass::places(const Setting& setting) const {
  return sensor_places(setting);
}

std::vector<ParameterSpec> SensorMass::parameters(
    const Where& where, const Setting& setting) const {
  const double start = std::min(0.02, 0.02 * setting.mass_kg);
  const double lower = 1e-5 * setting.mass_kg;
  const double upper = 0.5 * setting.mass_kg;
  if (where.variant != "each") {
    return {{"mass_kg", start, lower, upper}};
  }
  std::vector<ParameterSpec> specs;
  for (const std::string& channel : where.channels) {
    specs.push_back({"mass_kg." + channel, start, lower, upper});
  }
  return specs;
}

std::vector<ActedDof> SensorMass::acts_on(const Where& where,
                                          const Setting& setting,
                                          std::size_t run) const {
  std::vector<ActedDof> result;
  const bool shared = where.variant != "each";
  std::set<int> done;
  for (const PlacedSensor& sensor : placed_sensors(where, setting, run)) {
    // A triaxial sensor is one mass under three names.
    if (!done.insert(sensor.dof.node).second && shared) continue;
    for (ActedDof dof : translations({.node = sensor.dof.node}, setting)) {
      dof.group = group_of(where, sensor.position);
      result.push_back(dof);
    }
    if (where.variant != "rotary") continue;
    for (int component = 4; component <= 6; ++component) {
      result.push_back({sensor.dof.node, component, inertia});
    }
  }
  return result;
}

std::complex<double> SensorMass::law(std::complex<double> s,
                                     const std::vector<double>& p,
                                     std::size_t group) const {
  return s * s * p[group];
}

std::complex<double> SensorMass::law_derivative(std::complex<double> s,
                                                const std::vector<double>&,
                                                std::size_t group,
                                                std::size_t k) const {
  return group == k ? s * s : 0.0;
}

std::vector<std::string> SensorMass::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  std::vector<std::string> cards = {
      "$ The sensors' mass, where they sat in the first run"};
  std::map<int, double> mass_at;
  for (const ActedDof& dof : acts_on(where, setting, 0)) {
    if (dof.component == 1) mass_at[dof.node] += p[dof.group];
  }
  const double of_unit = where.variant == "rotary" ? inertia : 0.0;
  int offset = 0;
  const structure::Deck& deck = *setting.deck;
  for (const auto& [node, mass] : mass_at) {
    for (std::string& note : card_note(deck, node)) {
      cards.push_back(std::move(note));
    }
    cards.push_back(point_mass_card(
        deck, offset++, card_grid(deck, node), mass, of_unit * mass));
  }
  return cards;
}

std::vector<Effect::Derived> SensorMass::derived(const Where& where,
                                                 const Setting&) const {
  if (where.variant != "rotary") return {};
  return {{"inertia_kg_m2", {inertia}}};
}

}  // namespace tapfit::effects
