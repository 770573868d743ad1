#include "updating/measurement/mode_choices.hpp"

#include <cmath>

namespace tapfit::updating {

bool same_modes(const ModeChoices& a, const ModeChoices& b) {
  return a.band_hz == b.band_hz && a.edits == b.edits;
}

ModeChoices with_pair(ModeChoices choices, const PairByHand& pair) {
  // Two modes are rarely nearer than the digits in which they are shown.
  constexpr double same = 1e-4;
  std::erase_if(choices.pairs, [&pair](const PairByHand& known) {
    return std::abs(known.measured_hz - pair.measured_hz) <=
               same * pair.measured_hz ||
           (pair.model >= 0 && known.model == pair.model);
  });
  choices.pairs.push_back(pair);
  return choices;
}

}  // namespace tapfit::updating
