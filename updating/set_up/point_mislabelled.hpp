// A sensor or a blow at another grid than the sheet has it at: a point read off
// wrongly, a sensor moved and not noted. Its FRFs are those of the grid where
// it was.
#pragma once

#include "updating/set_up/sheet_mistake.hpp"

namespace tapfit::effects {

class PointMislabelled final : public SheetMistake {
 public:
  [[nodiscard]] std::string name() const override {
    return "point-mislabelled";
  }
  [[nodiscard]] std::string physics() const override {
    return "a sensor or blow at another grid than written down; poles are "
           "right, its FRFs are another point's";
  }
  /// Grids of the sheet, whole and, of sensors, parted by runs. The grid where
  /// it was is left open. None at points of the test's own: their directions
  /// are along axes of their own, and mean nothing at another grid.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] bool at_sheet_points() const override { return true; }
  [[nodiscard]] bool takes_any_grid() const override { return true; }
  void correct(const Where& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override;
};

}  // namespace tapfit::effects
