#include "updating/effect_place.hpp"

#include "acquisition/input_error.hpp"
#include "updating/effects/catalogue.hpp"
#include "updating/fitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace tapfit::updating {

EffectRef parse_effect(const std::string& text) {
  const std::size_t at = text.find('@');
  EffectRef ref;
  ref.effect = text.substr(0, at);
  static_cast<void>(effects::find(ref.effect));
  if (at == std::string::npos) return ref;
  const std::string place = text.substr(at + 1);
  const bool number =
      !place.empty() &&
      std::all_of(place.begin(), place.end(), [](unsigned char c) {
        return std::isdigit(c) != 0;
      });
  if (number && place.size() < 10) {
    ref.where.node = std::stoi(place);
  } else if (place == "rotation" || place == "translation" || place == "each") {
    ref.where.variant = place;
  } else if (!place.empty()) {
    ref.where.channels = {place};
  } else {
    throw InputError("no place after the @",
                     fmt::format("effect \"{}\"", text),
                     "write for example added-mass@201");
  }
  return ref;
}

PlacedEffect place_effect(const EffectRef& ref, const effects::Setting& s) {
  const effects::Effect& effect = effects::find(ref.effect);
  for (Where where : effect.places(s)) {
    const Where& want = ref.where;
    if (want.variant == "each") where.variant = "each";
    const bool agrees =
        (want.node == 0 || want.node == where.node) &&
        (want.nodes.empty() || want.nodes == where.nodes) &&
        (want.elements.empty() || want.elements == where.elements) &&
        (want.channels.empty() || want.channels == where.channels) &&
        (want.variant.empty() || want.variant == where.variant);
    const bool open = want.node == 0 && where.node != 0;
    if (agrees && !open) return placed(effect, where, s);
  }
  throw InputError(
      fmt::format("{} cannot sit there", ref.effect),
      fmt::format("effect \"{}{}{}\"",
                  ref.effect,
                  ref.where.node != 0 ? "@" : " at ",
                  ref.where.node != 0 ? fmt::format("{}", ref.where.node)
                                      : describe(ref.where)),
      "give a grid of the model that can move, a sensor channel, "
      "or a support of the model");
}

}  // namespace tapfit::updating
