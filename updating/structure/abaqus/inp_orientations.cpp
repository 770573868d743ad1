// *ORIENTATION: rectangular and cylindrical axes of materials.
#include "acquisition/foundation/coordinate_system.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <numbers>

namespace tapfit::structure {
namespace {

Eigen::Vector3d point_in(const DataLine& line, std::size_t first) {
  return {number_or(line, first, 0.0, "point"),
          number_or(line, first + 1, 0.0, "point"),
          number_or(line, first + 2, 0.0, "point")};
}

Eigen::Matrix3d turned(Eigen::Matrix3d axes, int about, double turn_deg) {
  if (about == 0) return axes;
  const Eigen::Vector3d axis = axes.col(about - 1);
  const double angle = turn_deg * std::numbers::pi / 180.0;
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix() * axes;
}

}  // namespace

Eigen::Matrix3d InpOrientation::axes(const Eigen::Vector3d& at) const {
  if (!cylindrical) {
    const auto found = axes_through(0, a, a.cross(b));
    // x along a, the x-y plane holds b: z is along a x b.
    return turned(
        found.value_or(Eigen::Matrix3d::Identity()), turned_about, turn_deg);
  }
  const Eigen::Vector3d z = (b - a).normalized();
  Eigen::Vector3d r = at - a;
  r -= z * z.dot(r);
  if (!(r.norm() > 0.0)) r = z.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes << r.normalized(), z.cross(r.normalized()), z;
  return turned(axes, turned_about, turn_deg);
}

void read_inp_orientations(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("ORIENTATION")) {
    InpOrientation o;
    const std::string system = keyword->option("SYSTEM");
    o.cylindrical = system == "CYLINDRICAL";
    const bool rectangular = system.empty() || system == "RECTANGULAR";
    const std::string definition = keyword->option("DEFINITION");
    if ((!rectangular && !o.cylindrical) ||
        (!definition.empty() && definition != "COORDINATES")) {
      keyword->fail("this kind of orientation is not read",
                    "Use SYSTEM=RECTANGULAR or CYLINDRICAL with "
                    "DEFINITION=COORDINATES.");
    }
    const DataLine& line = keyword->line(0, "two points");
    o.a = point_in(line, 0);
    o.b = point_in(line, 3);
    const Eigen::Vector3d origin =
        o.cylindrical ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                      : point_in(line, 6);
    if (!o.cylindrical) {
      o.a -= origin;
      o.b -= origin;
    }
    const bool given =
        o.cylindrical ? (o.b - o.a).norm() > 0.0 : o.a.cross(o.b).norm() > 0.0;
    if (!given) {
      keyword->fail("its two points give no axes",
                    "Give two points off one line.");
    }
    if (keyword->lines.size() > 1) {
      const DataLine& turn = keyword->lines[1];
      o.turned_about = integer_in(turn, 0, "axis of the turn");
      o.turn_deg = number_or(turn, 1, 0.0, "turn");
      if (o.turned_about < 1 || o.turned_about > 3) {
        fail_at(turn.place, "the axis is not 1, 2 or 3", "Correct it.");
      }
    }
    deck.orientations[keyword->needed_option("NAME")] = o;
  }
}

const InpOrientation& orientation_of(const InpDeck& deck,
                                     const std::string& name,
                                     const Place& asks) {
  const auto found = deck.orientations.find(name);
  if (found == deck.orientations.end()) {
    constexpr std::size_t most = 40;
    fail_at(
        asks,
        fmt::format("the orientation {} is not defined", name.substr(0, most)),
        "Define it by *ORIENTATION, NAME=..., or correct the name.");
  }
  return found->second;
}

}  // namespace tapfit::structure
