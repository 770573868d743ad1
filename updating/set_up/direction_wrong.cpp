#include "updating/set_up/direction_wrong.hpp"

#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/sheet_points.hpp"

#include <set>
#include <utility>

namespace tapfit::effects {
namespace {

struct WrittenDirections {
  std::set<std::pair<int, int>> all;  // component, sign
  std::set<int> grids;
};

WrittenDirections directions_of(const Where& where,
                                const acquisition::TestBundle& sheet) {
  WrittenDirections result;
  acquisition::TestBundle copy = sheet;
  for_each_meant(where, sheet, copy, [&](const acquisition::Placement& p) {
    result.all.insert({p.dof.component, p.dof.sign});
    result.grids.insert(p.dof.node);
  });
  return result;
}

// @param flips whether the same axis the other way round is one of them
void add_directions(const Where& where,
                    bool flips,
                    const DirectionWrong& effect,
                    const acquisition::TestBundle& sheet,
                    std::vector<Where>& places) {
  const auto written = directions_of(where, sheet).all;
  for (const std::string& direction : effect.variants()) {
    const Dof real = *parse_direction(0, direction);
    const bool same =
        written.size() == 1 && written.contains({real.component, real.sign});
    const bool flip =
        written.size() == 1 && written.contains({real.component, -real.sign});
    if (same || (flip && !flips)) continue;
    places.push_back(where);
    places.back().variant = direction;
  }
}

}  // namespace

std::vector<std::string> DirectionWrong::variants() const {
  return {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
}

std::vector<Where> DirectionWrong::places(const Setting& setting) const {
  const acquisition::TestBundle& sheet = *setting.bundle;
  std::vector<Where> whole = sensor_places(setting);
  std::set<std::size_t> hammers;
  for (const acquisition::Run& run : sheet.runs) {
    hammers.insert(run.hammer.channel);
  }
  for (const std::size_t channel : hammers) {
    whole.emplace_back();
    whole.back().channels = {sheet.channels[channel].name};
  }
  std::vector<Where> result;
  for (const Where& where : whole) {
    add_directions(where, false, *this, sheet, result);
  }
  for (const Where& point : written_points(setting)) {
    Where channels = point;
    channels.nodes.clear();
    if (directions_of(channels, sheet).grids.size() < 2) continue;
    add_directions(point, true, *this, sheet, result);
  }
  return result;
}

void DirectionWrong::correct(const Where& where,
                             const acquisition::TestBundle& written,
                             acquisition::TestBundle& sheet) const {
  const auto real = parse_direction(0, where.variant);
  if (!real) return;
  for_each_meant(where, written, sheet, [&](acquisition::Placement& p) {
    p.dof.component = real->component;
    p.dof.sign = real->sign;
  });
}

}  // namespace tapfit::effects
