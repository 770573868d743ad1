// Points and directions in the names of channels.
#pragma once

#include "acquisition/foundation/dof.hpp"

#include <optional>
#include <string_view>

namespace tapfit::acquisition {

/// The point that ends a name: "12Z+", "acc 12:+Z", "wing:12:+Z", "a_3X"; empty
/// where it ends with none.
[[nodiscard]] std::optional<Dof> point_in_name(std::string_view name);

/// A name that ends with an axis, as those of a triaxial sensor: "acc1x",
/// "A_Y", "seat +Z".
struct AxisName {
  std::string_view sensor;  ///< what stands before: "acc1", "A", "seat"
  int component = 3;        ///< 1..3
  int sign = 1;
};
[[nodiscard]] std::optional<AxisName> axis_in_name(std::string_view name);

}  // namespace tapfit::acquisition
