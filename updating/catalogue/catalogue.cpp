#include "updating/catalogue/catalogue.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/effects/effects.hpp"
#include "updating/set_up/mistakes.hpp"

#include <fmt/format.h>

#include <array>

namespace tapfit::effects {

std::span<const Effect* const> catalogue() {
  static const std::array effects = {
      &sensor_mass(),      &soft_support(), &added_mass(),
      &ground_spring(),    &dashpot(),      &sensor_cable(),
      &stiffness_loss(),   &joint(),        &prestress(),
      &absorber(),         &channel_gain(), &channel_delay(),
      &channel_polarity(), &channel_swap(), &point_mislabelled(),
      &direction_wrong(),  &unit_factor(),  &support_mismatch(),
      &card_swap(),        &damping_law(),
  };
  return effects;
}

const Effect& find(const std::string& name) {
  std::vector<std::string> known;
  for (const Effect* effect : catalogue()) {
    if (effect->name() == name) return *effect;
    known.push_back(effect->name());
  }
  if (name == updating::nonlinearity)
    throw InputError(
        "no linear model holds a nonlinearity: it cannot be added",
        "effect",
        "look for play, friction or large motions, and hit evenly");
  throw InputError(fmt::format("there is no effect \"{}\"", name),
                   "effect",
                   fmt::format("{}use one of {}",
                               did_you_mean(name, known),
                               fmt::join(known, ", ")));
}

}  // namespace tapfit::effects
