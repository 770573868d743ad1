// What the structure weighs, as said, by the scale or by the deck, and what of
// the sheet speaks against it.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/checks/frf_checks.hpp"

#include <optional>
#include <vector>

namespace tapfit::updating {

class BodyMass {
 public:
  /// @param said_kg of the body with its sensors, where known
  /// @param deck_kg 0: not known
  BodyMass(const acquisition::TestBundle& bundle,
           std::optional<double> said_kg,
           double deck_kg);

  /// Where scale and deck differ, that of the two counts that the structure
  /// moves like; both, where it moves like both or neither.
  void compare_with(const signal::FrfSet& set,
                    const modal::ModeSet& modes,
                    const std::vector<signal::DrivingPoint>& points);

  /// With the sensors, where it was weighed [kg]; 0: not known.
  [[nodiscard]] double kg() const;
  /// Share that a mass line may exceed it by.
  [[nodiscard]] double tolerance() const;

  /// Scale and deck that differ, sensors heavier than what they sit on.
  [[nodiscard]] std::vector<Finding> findings() const;

 private:
  enum class Right { Unknown, Scale, Deck };

  const acquisition::TestBundle& bundle_;
  std::optional<double> said_kg_;
  double deck_kg_ = 0.0;
  double weighed_kg_ = 0.0;           // with the sensors
  std::optional<Finding> differing_;  // scale and deck
  Right right_ = Right::Unknown;
};

}  // namespace tapfit::updating
