// A sensor or a blow at another grid than the sheet has it at: a point read off
// wrongly, a sensor moved and not noted. Its FRFs are those of the grid where
// it was.
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_mistake.hpp"
#include "updating/set_up/sheet_points.hpp"

namespace tapfit::effects {
namespace {

class PointMislabelled final : public SheetMistake {
 public:
  PointMislabelled()
      : SheetMistake({.name = "point-mislabelled",
                      .words = "point that was elsewhere than written down",
                      .entry = Entry::Measurement,
                      .sits = Sits::AtSheetPoints,
                      .law = Law::Own,
                      .takes_any_grid = true}) {}

  // Grids of the sheet, whole and, of sensors, parted by runs. The grid where
  // it was is left open. None at points of the test's own: their directions are
  // along axes of their own, and mean nothing at another grid.
  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result = written_points(context);
    // A point of the test's own has coordinates, not a number to mistake.
    std::erase_if(
        result, [](const Location& point) { return point.nodes.front() < 0; });
    const std::size_t whole = result.size();
    for (std::size_t k = 0; k < whole; ++k) {
      for (Location& part :
           parted_by_runs(Location(result[k]), *context.bundle)) {
        result.push_back(std::move(part));
      }
    }
    return result;
  }

  void correct(const Location& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override {
    if (where.node == 0) return;
    for_each_meant(where, written, sheet, [&](acquisition::Placement& p) {
      p.dof.node = where.node;
    });
  }
};

}  // namespace

const Effect& point_mislabelled() {
  static const PointMislabelled effect;
  return effect;
}

}  // namespace tapfit::effects
