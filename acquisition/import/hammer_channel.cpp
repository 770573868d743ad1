#include "acquisition/import/hammer_channel.hpp"

#include "acquisition/foundation/units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

bool is_force(const TimeRecord& record) {
  const std::optional<Unit> unit = find_unit(record.unit);
  return unit && unit->quantity == Quantity::Force;
}

// What is in another unit is no force.
bool may_be_force(const TimeRecord& record) {
  return is_force(record) || !find_unit(record.unit);
}

}  // namespace

double one_sidedness(const Eigen::VectorXd& values) {
  if (values.size() == 0) return 0.0;
  Eigen::ArrayXd off = values.array() - values.mean();
  off /= off.abs().maxCoeff();  // so that no power of it overflows
  const double square = off.square().mean();
  if (!(square > 0.0)) return 0.0;
  return std::abs(off.cube().mean()) / std::pow(square, 1.5);
}

HammerChoice choose_hammer(const std::vector<const TimeRecord*>& records) {
  std::size_t forces = 0;
  bool any = false;
  for (const TimeRecord* record : records) {
    if (is_force(*record)) ++forces;
    any = any || may_be_force(*record);
  }
  HammerChoice choice;
  double best = -1.0;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const TimeRecord& record = *records[k];
    if (forces > 0 ? !is_force(record) : any && !may_be_force(record)) continue;
    const double here = one_sidedness(record.values);
    if (here <= best) continue;
    best = here;
    choice.channel = k;
  }
  choice.certain = forces == 1;
  choice.reason =
      choice.certain
          ? fmt::format("its unit, {}", records[choice.channel]->unit)
          : fmt::format("its pulses, the shortest to one side{}",
                        forces > 1 ? " of all in units of force" : "");
  return choice;
}

}  // namespace tapfit::acquisition
