// What the user decided about the modes: the band they are sought in, poles
// taken out and put in, and which of the model's modes a measured one is.
#pragma once

#include "modal/mode_set/pairing.hpp"
#include "modal/poles/pole_edit.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Named by its frequency: numbers change when a mode before it is dropped.
struct PairByHand {
  double measured_hz = 0.0;  ///< the measured mode nearest to it, within 2 %
  int model = -1;            ///< index of the model's mode; -1: has no partner

  bool operator==(const PairByHand&) const = default;
};

struct ModeChoices {
  std::optional<std::array<double, 2>> band_hz;  ///< else all lines
  std::vector<modal::PoleEdit> edits;            ///< in the order made
  std::vector<PairByHand> pairs;

  bool operator==(const ModeChoices&) const = default;
  [[nodiscard]] bool empty() const { return *this == ModeChoices{}; }
};

/// Whether both lead to the same modes, whatever their pairs.
[[nodiscard]] bool same_modes(const ModeChoices& a, const ModeChoices& b);

/// With one more pair; those before it that it contradicts are gone: the one of
/// the same measured mode and the one of the same mode of the model.
[[nodiscard]] ModeChoices with_pair(ModeChoices choices,
                                    const PairByHand& pair);

/// By index.
///
/// @param measured_hz of the measured modes [Hz], at least one
/// @param model_modes how many the model has
/// @param notes takes what cannot be kept to: a pair of which no measured mode
///   or none of the model's is there, or one of them has a pair before
[[nodiscard]] std::vector<modal::Pair> pairs_by_index(
    const std::vector<PairByHand>& by_hand,
    const Eigen::VectorXd& measured_hz,
    Eigen::Index model_modes,
    std::vector<std::string>& notes);

}  // namespace tapfit::updating
