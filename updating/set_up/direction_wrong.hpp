// A sensor or a blow along another axis than the sheet has it, or the other way
// round: X written for Z. What has several directions, a triaxial sensor, was
// turned as one body: by one of the 23 turns that bring axes onto axes.
#pragma once

#include "updating/set_up/sheet_mistake.hpp"

namespace tapfit::effects {

class DirectionWrong final : public SheetMistake {
 public:
  [[nodiscard]] std::string name() const override { return "direction-wrong"; }
  [[nodiscard]] std::string physics() const override {
    return "a sensor or blow along another axis than written down; poles are "
           "right, its FRFs are another direction's";
  }
  /// Each channel, all sensors together, and each point of a channel that is
  /// moved, in every direction but the one written, "+X"; where several are
  /// written, in every other turn of them all, "XYZ=+Y-X+Z": what X, Y and Z of
  /// the sheet are in truth. A channel that has the wrong sign everywhere is
  /// ChannelPolarity.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] bool at_sheet_points() const override { return true; }
  [[nodiscard]] std::vector<std::string> variants() const override;
  void correct(const Where& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override;
};

}  // namespace tapfit::effects
