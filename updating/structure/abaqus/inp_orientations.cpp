// *ORIENTATION: rectangular and cylindrical axes of materials.
#include "acquisition/foundation/coordinate_system.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace tapfit::structure {
namespace {

InpOrientation orientation_in(const Keyword& keyword) {
  InpOrientation o;
  const std::string system = keyword.option("SYSTEM");
  const std::string definition = keyword.option("DEFINITION");
  o.cylindrical = system == "CYLINDRICAL";
  const bool rectangular = system.empty() || system == "RECTANGULAR";
  if ((!rectangular && !o.cylindrical) ||
      (!definition.empty() && definition != "COORDINATES")) {
    keyword.fail("this kind of orientation is not read",
                 "Use SYSTEM=RECTANGULAR or CYLINDRICAL with "
                 "DEFINITION=COORDINATES.");
  }
  const DataLine& line = keyword.line(0, "two points");
  o.a = vector_in(line, 0, "point");
  o.b = vector_in(line, 3, "point");
  if (!o.cylindrical) {
    const Eigen::Vector3d origin = vector_in(line, 6, "point");
    o.a -= origin;
    o.b -= origin;
  }
  const bool given =
      o.cylindrical ? (o.b - o.a).norm() > 0.0 : o.a.cross(o.b).norm() > 0.0;
  if (!given) {
    keyword.fail("its two points give no axes",
                 "Give two points off one line.");
  }
  if (keyword.lines.size() > 1) {
    const DataLine& turn = keyword.lines[1];
    o.turned_about = integer_in(turn, 0, "axis of the turn");
    o.turn_deg = number_or(turn, 1, 0.0, "turn");
    if (o.turned_about < 1 || o.turned_about > 3) {
      fail_at(turn.place, "the axis is not 1, 2 or 3", "Correct it.");
    }
  }
  return o;
}

}  // namespace

Eigen::Matrix3d InpOrientation::axes(const Eigen::Vector3d& at) const {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (cylindrical) {
    const Eigen::Vector3d z = (b - a).normalized();
    Eigen::Vector3d r = at - a;
    r -= z * z.dot(r);
    if (!(r.norm() > 0.0)) r = z.unitOrthogonal();
    axes << r.normalized(), z.cross(r.normalized()), z;
  } else {
    // x along a, the x-y plane holds b: z is along a x b.
    axes = axes_through(0, a, a.cross(b)).value_or(axes);
  }
  if (turned_about == 0) return axes;
  const Eigen::Vector3d axis = axes.col(turned_about - 1);
  const double angle = turn_deg * std::numbers::pi / 180.0;
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix() * axes;
}

void read_inp_orientations(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("ORIENTATION")) {
    deck.orientations[keyword->needed_option("NAME")] =
        orientation_in(*keyword);
  }
}

}  // namespace tapfit::structure
