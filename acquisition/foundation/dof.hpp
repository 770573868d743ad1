// A measured degree of freedom: a grid and a signed direction, "12Z+".
#pragma once

#include <Eigen/Core>

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace tapfit {

/// A point and direction of measurement, in the model's basic axes.
struct Dof {
  int node = 0;       ///< grid id
  int component = 3;  ///< 1..3 = X, Y, Z; 4..6 = rotations
  int sign = 1;       ///< +1 or -1

  auto operator<=>(const Dof&) const = default;
};

/// The field's short name: "12Z+", "7X-", rotations "3RZ+".
[[nodiscard]] std::string name(const Dof& dof);

/// Reads "+Z", "-X", "Z", "Z+" (any case) into component and sign, with the
/// node given; empty when the text is no direction.
[[nodiscard]] std::optional<Dof> parse_direction(int node,
                                                 std::string_view text);

/// Reads a whole point: "12Z+", "12:+Z", "12:Z"; empty when it is none.
[[nodiscard]] std::optional<Dof> parse_dof(std::string_view text);

}  // namespace tapfit
