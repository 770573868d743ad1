#include "updating/effects/sensor_cable.hpp"

#include "updating/effects/sensor_channels.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::effects {

std::vector<Where> SensorCable::places(const Setting& setting) const {
  return sensor_places(setting);
}

std::vector<ParameterSpec> SensorCable::parameters(
    const Where&, const Setting& setting) const {
  // A cable is soft: it shows in the lowest modes or not at all.
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double stiffness = setting.mass_kg * low * low;
  const double damping = setting.mass_kg * low;
  return {{"stiffness_n_per_m",
           1e-2 * stiffness,
           1e-5 * stiffness,
           10.0 * stiffness},
          {"damping_ns_per_m", 1e-3 * damping, 1e-6 * damping, damping}};
}

std::vector<ActedDof> SensorCable::acts_on(const Where& where,
                                           const Setting& setting,
                                           std::size_t run) const {
  std::vector<ActedDof> result;
  for (const PlacedSensor& sensor : placed_sensors(where, setting, run)) {
    result.push_back({sensor.dof.node, sensor.dof.component, 1.0, 0});
  }
  return result;
}

std::complex<double> SensorCable::law(std::complex<double> s,
                                      const std::vector<double>& p,
                                      std::size_t) const {
  return p[0] + s * p[1];
}

std::complex<double> SensorCable::law_derivative(std::complex<double> s,
                                                 const std::vector<double>&,
                                                 std::size_t,
                                                 std::size_t k) const {
  return k == 0 ? std::complex<double>(1.0) : s;
}

std::vector<std::string> SensorCable::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  std::vector<std::string> cards = {
      "$ The sensors' cables, where they hung in the first run"};
  int offset = 0;
  const auto add = [&](const std::vector<std::string>& more) {
    cards.insert(cards.end(), more.begin(), more.end());
    offset += static_cast<int>(more.size());
  };
  const structure::Deck& deck = *setting.deck;
  for (const ActedDof& acted : acts_on(where, setting, 0)) {
    const Dof dof{acted.node, acted.component, 1};
    add(card_note(deck, dof.node));
    add(axis_note(deck, dof));
    const int grid = card_grid(deck, dof.node);
    const int axis = card_axis(deck, dof);
    add(ground_spring_cards(deck, offset, grid, axis, p[0]));
    add(ground_damper_cards(deck, offset, grid, axis, p[1]));
  }
  return cards;
}

}  // namespace tapfit::effects
