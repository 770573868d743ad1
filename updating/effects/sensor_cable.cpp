// The accelerometers' cables: a light spring and damper from each sensor to
// ground, Delta Z = k + s c in the measured direction. They move with a roving
// sensor.
#include "updating/effects/effects.hpp"
#include "updating/effects/sensor_channels.hpp"
#include "updating/structure/edit/deck_cards.hpp"

namespace tapfit::effects {
namespace {

class SensorCable final : public Effect {
 public:
  SensorCable()
      : Effect({.name = "sensor-cable",
                .words = "pull of the sensor cables",
                .sits = Sits::OnChannels,
                .law = Law::Own}) {}

  // All sensor channels with cables alike, then each channel alone.
  std::vector<Location> places(const TestContext& context) const override {
    return sensor_places(context);
  }

  std::vector<ParameterSpec> parameters(
      const Location&, const TestContext& context) const override {
    // A cable is soft: it shows in the lowest modes or not at all.
    const double low = context.low();
    const double k = context.mass_kg * low * low;
    const double c = context.mass_kg * low;
    return {{"stiffness_n_per_m", 1e-2 * k, 1e-5 * k, 10.0 * k},
            {"damping_ns_per_m", 1e-3 * c, 1e-6 * c, c}};
  }

  std::vector<InterfaceDof> interface_dofs(const Location& where,
                                           const TestContext& context,
                                           std::size_t run) const override {
    std::vector<InterfaceDof> result;
    for (const PlacedSensor& sensor : placed_sensors(where, context, run)) {
      result.push_back({sensor.dof.node, sensor.dof.component, 1.0, 0});
    }
    return result;
  }

  // The spring; the damper is not.
  bool is_lossless(std::size_t k) const override { return k == 0; }

  std::complex<double> law(std::complex<double> s,
                           const std::vector<double>& p,
                           std::size_t) const override {
    return p[0] + s * p[1];
  }

  std::complex<double> law_derivative(std::complex<double> s,
                                      const std::vector<double>&,
                                      std::size_t,
                                      std::size_t k) const override {
    return k == 0 ? std::complex<double>(1.0) : s;
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    std::vector<std::string> cards = {
        "$ The sensors' cables, where they hung in the first run"};
    int offset = 0;
    const auto add = [&](const std::vector<std::string>& more) {
      cards.insert(cards.end(), more.begin(), more.end());
      offset += static_cast<int>(more.size());
    };
    const structure::Deck& deck = *context.deck;
    for (const InterfaceDof& acted : interface_dofs(where, context, 0)) {
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
};

}  // namespace

const Effect& sensor_cable() {
  static const SensorCable effect;
  return effect;
}

}  // namespace tapfit::effects
