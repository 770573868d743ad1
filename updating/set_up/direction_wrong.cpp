// A sensor or a blow along another axis than the sheet has it, or the other way
// round: X written for Z. What has several directions, a triaxial sensor, was
// turned as one body: by one of the 23 turns that bring axes onto axes.
#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_mistake.hpp"
#include "updating/set_up/sheet_points.hpp"

#include <Eigen/Geometry>

#include <set>
#include <string_view>
#include <utility>

namespace tapfit::effects {
namespace {

// Along which axes, and where.
struct WrittenDirections {
  std::set<Dof> all;  // of no node
  std::set<int> grids;
};

Dof at_node(int node, Dof dof) {
  dof.node = node;
  return dof;
}

WrittenDirections directions_of(const Location& where,
                                const acquisition::TestBundle& sheet) {
  WrittenDirections result;
  acquisition::TestBundle copy = sheet;
  for_each_meant(where, sheet, copy, [&](const acquisition::Placement& p) {
    result.all.insert(at_node(0, p.dof));
    result.grids.insert(p.dof.node);
  });
  return result;
}

std::vector<std::string> basic_axes() {
  return {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
}

// What the axes X, Y and Z of the sheet are in truth.
constexpr std::string_view turned_axes = "XYZ=";

std::vector<std::string> quarter_turns() {
  const auto along = [](const std::string& axis) {
    const Dof dof = *parse_direction(0, axis);
    return Eigen::Vector3d(dof.sign * Eigen::Vector3d::Unit(dof.component - 1));
  };
  const std::vector<std::string> axes = basic_axes();
  std::vector<std::string> result;
  for (const std::string& x : axes) {
    for (const std::string& y : axes) {
      const Eigen::Vector3d across = along(x).cross(along(y));
      for (const std::string& z : axes) {
        const bool right_handed = across == along(z);
        const bool as_it_was = x == "+X" && y == "+Y";
        if (right_handed && !as_it_was) {
          result.push_back(std::string(turned_axes) + x + y + z);
        }
      }
    }
  }
  return result;
}

// One axis is said as it is, several by what the axes are.
Dof put_right(const Dof& dof, std::string_view variant) {
  if (!variant.starts_with(turned_axes)) {
    return parse_direction(dof.node, variant).value_or(dof);
  }
  const int rotation = dof.component > 3 ? 3 : 0;
  const auto axis = static_cast<std::size_t>(dof.component - rotation - 1);
  const auto real = parse_direction(
      dof.node, variant.substr(turned_axes.size() + 2 * axis, 2));
  if (!real) return dof;
  return {dof.node, real->component + rotation, dof.sign * real->sign};
}

// @param flips whether the same axes the other way round are one of them
void add_directions(const Location& where,
                    bool flips,
                    const acquisition::TestBundle& sheet,
                    std::vector<Location>& places) {
  const std::set<Dof> written = directions_of(where, sheet).all;
  using Directions = std::vector<Dof>;
  Directions flipped(written.begin(), written.end());
  std::set<Directions> known = {flipped};
  for (Dof& dof : flipped) dof.sign = -dof.sign;
  if (!flips) known.insert(flipped);
  for (const std::string& variant :
       written.size() > 1 ? quarter_turns() : basic_axes()) {
    Directions real;
    for (const Dof& dof : written) real.push_back(put_right(dof, variant));
    if (!known.insert(real).second) continue;
    places.push_back(where);
    places.back().variant = variant;
  }
}

std::vector<std::string> all_directions() {
  std::vector<std::string> all = basic_axes();
  for (std::string& turned : quarter_turns()) all.push_back(std::move(turned));
  return all;
}

class DirectionWrong final : public SheetMistake {
 public:
  DirectionWrong()
      : SheetMistake({.name = "direction-wrong",
                      .words = "direction other than written down",
                      .entry = Entry::Measurement,
                      .sits = Sits::AtSheetPoints,
                      .law = Law::Own,
                      .variants = all_directions()}) {}

  // Each channel, all sensors together, and each point of a channel that is
  // moved, in every direction but the one written, "+X"; where several are
  // written, in every other turn of them all, "XYZ=+Y-X+Z": what X, Y and Z of
  // the sheet are in truth. A channel that has the wrong sign everywhere is
  // ChannelPolarity.
  std::vector<Location> places(const TestContext& context) const override {
    const acquisition::TestBundle& sheet = *context.bundle;
    std::vector<Location> whole = sensor_places(context);
    const std::vector<Location> hammers = hammer_places(context);
    whole.insert(whole.end(), hammers.begin(), hammers.end());
    std::vector<Location> result;
    for (const Location& where : whole) {
      add_directions(where, false, sheet, result);
    }
    for (const Location& point : written_points(context)) {
      Location channels = point;
      channels.nodes.clear();
      if (directions_of(channels, sheet).grids.size() < 2) continue;
      add_directions(point, true, sheet, result);
    }
    return result;
  }

  void correct(const Location& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override {
    for_each_meant(where, written, sheet, [&](acquisition::Placement& p) {
      p.dof = put_right(p.dof, where.variant);
    });
  }
};

}  // namespace

const Effect& direction_wrong() {
  static const DirectionWrong effect;
  return effect;
}

}  // namespace tapfit::effects
