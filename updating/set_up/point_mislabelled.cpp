#include "updating/set_up/point_mislabelled.hpp"

#include "updating/set_up/sheet_points.hpp"

namespace tapfit::effects {

std::vector<Where> PointMislabelled::places(const Setting& setting) const {
  std::vector<Where> result = written_points(setting);
  // A point of the test's own has coordinates, not a number to mistake.
  std::erase_if(result,
                [](const Where& point) { return point.nodes.front() < 0; });
  const std::size_t whole = result.size();
  for (std::size_t k = 0; k < whole; ++k) {
    for (Where& part : parted_by_runs(Where(result[k]), *setting.bundle)) {
      result.push_back(std::move(part));
    }
  }
  return result;
}

void PointMislabelled::correct(const Where& where,
                               const acquisition::TestBundle& written,
                               acquisition::TestBundle& sheet) const {
  if (where.node == 0) return;
  for_each_meant(where, written, sheet, [&](acquisition::Placement& p) {
    p.dof.node = where.node;
  });
}

}  // namespace tapfit::effects
