#include "updating/catalogue/catalogue.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "updating/effects/absorber.hpp"
#include "updating/effects/added_mass.hpp"
#include "updating/effects/damping_law.hpp"
#include "updating/effects/dashpot.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/effects/ground_spring.hpp"
#include "updating/effects/joint.hpp"
#include "updating/effects/prestress.hpp"
#include "updating/effects/sensor_cable.hpp"
#include "updating/effects/sensor_mass.hpp"
#include "updating/effects/soft_support.hpp"
#include "updating/effects/stiffness_loss.hpp"
#include "updating/set_up/channel_delay.hpp"
#include "updating/set_up/channel_gain.hpp"
#include "updating/set_up/channel_polarity.hpp"
#include "updating/set_up/channel_swap.hpp"
#include "updating/set_up/direction_wrong.hpp"
#include "updating/set_up/point_mislabelled.hpp"
#include "updating/set_up/support_mismatch.hpp"
#include "updating/set_up/unit_factor.hpp"

#include <fmt/format.h>

#include <array>

namespace tapfit::effects {

std::span<const std::unique_ptr<const Effect>> catalogue() {
  static const std::array<std::unique_ptr<const Effect>, 19> effects = {
      std::make_unique<const SensorMass>(),
      std::make_unique<const SoftSupport>(),
      std::make_unique<const AddedMass>(),
      std::make_unique<const GroundSpring>(),
      std::make_unique<const Dashpot>(),
      std::make_unique<const SensorCable>(),
      std::make_unique<const StiffnessLoss>(),
      std::make_unique<const Joint>(),
      std::make_unique<const Prestress>(),
      std::make_unique<const Absorber>(),
      std::make_unique<const ChannelGain>(),
      std::make_unique<const ChannelDelay>(),
      std::make_unique<const ChannelPolarity>(),
      std::make_unique<const ChannelSwap>(),
      std::make_unique<const PointMislabelled>(),
      std::make_unique<const DirectionWrong>(),
      std::make_unique<const UnitFactor>(),
      std::make_unique<const SupportMismatch>(),
      std::make_unique<const DampingLaw>(),
  };
  return effects;
}

const Effect& find(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& effect : catalogue()) {
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
