#include "updating/practice/challenge.hpp"

#include "acquisition/foundation/seeded_random.hpp"
#include "updating/practice/practice_case.hpp"
#include "updating/virtual_test/structure_presets.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;

const std::vector<std::string>& told_well() {
  static const std::vector<std::string> kinds = {"sensor-mass",
                                                 "soft-support",
                                                 "added-mass",
                                                 "ground-spring",
                                                 "channel-gain"};
  return kinds;
}

const std::vector<std::string>& all_told() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all = told_well();
    for (const char* more : {"dashpot",
                             "stiffness-loss",
                             "joint",
                             "absorber",
                             "sensor-cable",
                             "channel-delay",
                             "channel-polarity"}) {
      all.emplace_back(more);
    }
    return all;
  }();
  return kinds;
}

// One of several, taken out of them.
std::string take_one(std::vector<std::string>& names, SeededRandom& random) {
  const auto count = static_cast<double>(names.size());
  const auto drawn = static_cast<std::size_t>(random.uniform(0.0, count));
  const std::size_t at = std::min(drawn, names.size() - 1);
  std::string name = names[at];
  names.erase(names.begin() + static_cast<std::ptrdiff_t>(at));
  return name;
}

std::vector<std::string> kinds_for(const std::string& structure,
                                   std::vector<std::string> kinds) {
  std::erase_if(kinds, [&structure](const std::string& kind) {
    return !can_hide(structure, kind);
  });
  return kinds;
}

VirtualBundleSpec easy(std::uint64_t seed,
                       const std::string& structure,
                       SeededRandom& random) {
  constexpr double large = 1.5;
  std::vector<std::string> kinds = kinds_for(structure, told_well());
  VirtualBundleSpec spec =
      draw_practice_case(take_one(kinds, random), seed, structure);
  for (VirtualEffect& effect : spec.effects) {
    effect = resized(std::move(effect), large);
  }
  spec.noise = 0.5;
  spec.modulus_percent = 0.0;
  return spec;
}

VirtualBundleSpec hard(std::uint64_t seed,
                       const std::string& structure,
                       SeededRandom& random) {
  constexpr double smallest = 1.0 / 12.0;
  constexpr double largest = 1.0 / 1.5;
  std::vector<std::string> kinds = kinds_for(structure, all_told());
  // In one case of five nothing; as often one as two.
  const double lot = random.uniform(0.0, 5.0);
  std::string kind = lot < 1.0 ? "none" : take_one(kinds, random);
  if (lot >= 3.0) kind += "+" + take_one(kinds, random);
  VirtualBundleSpec spec = draw_practice_case(kind, seed, structure);
  for (VirtualEffect& effect : spec.effects) {
    const double share =
        std::exp(random.uniform(std::log(smallest), std::log(largest)));
    effect = resized(std::move(effect), share);
  }
  spec.noise = random.uniform(2.0, 5.0);
  const double off = random.uniform(2.0, 4.0);
  spec.modulus_percent = random.uniform(0.0, 1.0) < 0.5 ? -off : off;
  return spec;
}

}  // namespace

VirtualEffect resized(VirtualEffect effect, double share) {
  std::vector<double>& values = effect.values;
  if (values.empty()) return effect;
  if (effect.name == "soft-support" || effect.name == "joint") {
    for (double& stiffness : values) stiffness /= share;
  } else if (effect.name == "stiffness-loss") {
    values[0] = 1.0 - share * (1.0 - values[0]);
  } else if (effect.name == "channel-gain") {
    values[0] = 1.0 + share * (values[0] - 1.0);
  } else if (effect.name == "absorber") {
    values[0] *= share;  // its frequency and damping are no sizes
  } else {
    for (double& value : values) value *= share;
  }
  return effect;
}

VirtualBundleSpec draw_challenge(ChallengeLevel level,
                                 std::uint64_t seed,
                                 const std::string& structure) {
  SeededRandom random(seed, "challenge");
  std::vector<std::string> structures = virtual_structures();
  const std::string drawn = take_one(structures, random);
  const std::string& chosen = structure.empty() ? drawn : structure;
  VirtualBundleSpec spec = level == ChallengeLevel::Easy
                               ? easy(seed, chosen, random)
                               : hard(seed, chosen, random);
  spec.sealed = true;
  return spec;
}

}  // namespace tapfit::updating
