// Physical units of measured quantities and their SI values.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tapfit::acquisition {

enum class Quantity { Force, Acceleration, Velocity, Displacement };

struct Unit {
  Quantity quantity = Quantity::Acceleration;
  double si = 1.0;  ///< SI value of one unit: N, m/s^2, m/s, m
};

/// Looks a unit up: "N", "lbf", "g", "mm/s^2", "m/s2", "m/s²" ..., and what
/// other programs write for them ("pound", "G", "g's", "m/sec^2"); blanks do
/// not matter, upper and lower case do. Empty when it is not known.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view text);

/// A sensitivity's unit such as "mV/g" or "V/(m/s^2)".
struct SensitivityUnit {
  double volts = 1.0;  ///< V per electrical unit (1e-3 for mV)
  Unit unit;           ///< what it is per
};

/// Empty when the text is no voltage per known unit (pC/N, for example).
[[nodiscard]] std::optional<SensitivityUnit> find_sensitivity_unit(
    std::string_view text);

/// "force", "acceleration", "velocity", "displacement".
[[nodiscard]] std::string name(Quantity quantity);
[[nodiscard]] std::optional<Quantity> find_quantity(std::string_view text);

/// The units known for a quantity, for error texts: "N, kN, lbf, ...".
[[nodiscard]] std::string known_units(Quantity quantity);

}  // namespace tapfit::acquisition
