// A measured degree of freedom: a point and a signed direction, "12Z+". Points
// are grids of the model, or the test's own, "P3Z+".
#pragma once

#include <Eigen/Core>

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace tapfit {

/// A point and direction of measurement: at a grid in the model's basic axes,
/// at a point of the test's own along that point's axes.
struct Dof {
  int node = 0;       ///< grid id; minus the label of a point of the test's own
  int component = 3;  ///< 1..3 = X, Y, Z; 4..6 = rotations
  int sign = 1;       ///< +1 or -1

  auto operator<=>(const Dof&) const = default;
};

/// A grid's id, "12", or the label of a point of the test's own, "P3".
[[nodiscard]] std::string node_name(int node);

/// The field's short name: "12Z+", "7X-", "P3Z+", rotations "3RZ+".
[[nodiscard]] std::string name(const Dof& dof);

/// Reads "+Z", "-X", "Z", "Z+" (any case) into component and sign, with the
/// node given; empty when the text is no direction.
[[nodiscard]] std::optional<Dof> parse_direction(int node,
                                                 std::string_view text);

/// Reads a whole point: "12Z+", "12:+Z", "12:Z", "P3Z+"; empty when it is none.
[[nodiscard]] std::optional<Dof> parse_dof(std::string_view text);

}  // namespace tapfit
