// The accelerometers' mass: Delta Z = s^2 m on the three translations of the
// grid where a sensor sits in the run at hand. It moves with a roving sensor.
// Form "rotary": s^2 m h^2 on the three rotations as well, for a body whose
// middle is h above the plate's, 10 mm.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/sensor_channels.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace tapfit::effects {
namespace {

// Inertia of a kilogram about the axes of the surface [m^2]: the middle of an
// accelerometer on its mount is some 10 mm above a plate's middle. Left free it
// would stand for whatever a deck lacks in its high modes.
constexpr double height = 0.01;
constexpr double inertia = height * height;

class SensorMass final : public Effect {
 public:
  SensorMass()
      : Effect({.name = "sensor-mass",
                .words = "mass of the sensors",
                .sits = Sits::OnChannels,
                .law = Law::Mass,
                .forms = {"each", "rotary"}}) {}

  bool takes(const std::string& form,
             const Location& place,
             const TestContext&) const override {
    return form == "rotary" || place.channels.size() > 1;
  }

  // All sensor channels sharing one mass, then each channel alone.
  std::vector<Location> places(const TestContext& context) const override {
    return sensor_places(context);
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    const double start = std::min(0.02, 0.02 * context.mass_kg);
    const double lower = 1e-5 * context.mass_kg;
    const double upper = 0.5 * context.mass_kg;
    if (where.variant != "each") return {{"mass_kg", start, lower, upper}};
    std::vector<ParameterSpec> specs;
    for (const std::string& channel : where.channels) {
      specs.push_back({"mass_kg." + channel, start, lower, upper});
    }
    return specs;
  }

  std::vector<InterfaceDof> interface_dofs(const Location& where,
                                           const TestContext& context,
                                           std::size_t run) const override {
    std::vector<InterfaceDof> result;
    const bool shared = where.variant != "each";
    std::set<int> done;
    for (const PlacedSensor& sensor : placed_sensors(where, context, run)) {
      // A triaxial sensor is one mass under three names.
      if (!done.insert(sensor.dof.node).second && shared) continue;
      for (InterfaceDof dof :
           translations({.node = sensor.dof.node}, context)) {
        dof.group = shared ? 0 : sensor.position;
        result.push_back(dof);
      }
      if (where.variant != "rotary") continue;
      for (int component = 4; component <= 6; ++component) {
        result.push_back({sensor.dof.node, component, inertia});
      }
    }
    return result;
  }

  std::vector<Derived> derived(const Location& where,
                               const TestContext&) const override {
    if (where.variant != "rotary") return {};
    return {{"inertia_kg_m2", {inertia}}};
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    std::vector<std::string> cards = {
        "$ The sensors' mass, where they sat in the first run"};
    std::map<int, double> mass_at;
    for (const InterfaceDof& dof : interface_dofs(where, context, 0)) {
      if (dof.component == 1) mass_at[dof.node] += p[dof.group];
    }
    const double of_unit = where.variant == "rotary" ? inertia : 0.0;
    int offset = 0;
    const structure::Deck& deck = *context.deck;
    for (const auto& [node, mass] : mass_at) {
      for (const std::string& note : card_note(deck, node)) {
        cards.push_back(note);
      }
      cards.push_back(point_mass_card(
          deck, offset++, card_grid(deck, node), mass, of_unit * mass));
    }
    return cards;
  }
};

}  // namespace

const Effect& sensor_mass() {
  static const SensorMass effect;
  return effect;
}

}  // namespace tapfit::effects
