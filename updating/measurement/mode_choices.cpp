#include "updating/measurement/mode_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<modal::Pair> pairs_by_index(const std::vector<PairByHand>& by_hand,
                                        const Eigen::VectorXd& measured_hz,
                                        Eigen::Index model_modes,
                                        std::vector<std::string>& notes) {
  constexpr double near = 0.02;
  std::vector<modal::Pair> pairs;
  for (const PairByHand& pair : by_hand) {
    Eigen::Index nearest = 0;
    const double apart =
        (measured_hz.array() - pair.measured_hz).abs().minCoeff(&nearest);
    const auto taken = [&](const modal::Pair& other) {
      return other.measured == nearest ||
             (pair.model >= 0 && other.model == pair.model);
    };
    const char* fault = nullptr;
    if (apart > near * pair.measured_hz) {
      fault = "no measured mode is within 2 %";
    } else if (pair.model >= model_modes) {
      fault = "the model has no such mode in the band";
    } else if (std::ranges::any_of(pairs, taken)) {
      fault = "its measured mode or the model's has a pair by hand already";
    }
    if (fault == nullptr) {
      pairs.push_back({nearest, pair.model, 0.0});
      continue;
    }
    notes.push_back(fmt::format(
        "the pair by hand {:.6g} Hz : {} is left out: "
        "{}",
        pair.measured_hz,
        pair.model < 0 ? std::string("none") : fmt::to_string(pair.model + 1),
        fault));
  }
  return pairs;
}

}  // namespace tapfit::updating
