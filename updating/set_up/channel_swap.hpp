// Two sensor channels with their cables (or their names) swapped: each recorded
// what the other should have.
#pragma once

#include "updating/set_up/sheet_mistake.hpp"

namespace tapfit::effects {

class ChannelSwap final : public SheetMistake {
 public:
  [[nodiscard]] std::string name() const override { return "channel-swap"; }
  [[nodiscard]] std::string physics() const override {
    return "two channels swapped; poles are right, each sensor's shape is the "
           "other's";
  }
  /// Every two sensor channels that measure at the same time.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  void correct(const Where& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override;
};

}  // namespace tapfit::effects
