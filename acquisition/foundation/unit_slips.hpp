// Units that are taken for each other, by how many times one is the other: what
// a channel, a weight or a deck is off by where its unit is not the one that is
// written down.
#pragma once

#include <span>
#include <string>

namespace tapfit::acquisition {

struct UnitSlip {
  const char* name;   ///< the factor to four digits
  double factor;      ///< above 1
  const char* words;  ///< which units, either way round
};

/// Of channels: between two units of one quantity.
[[nodiscard]] std::span<const UnitSlip> unit_slips();

/// Quotients and products of these that have a name of their own.
[[nodiscard]] std::span<const UnitSlip> composed_unit_slips();

/// The steps of an amplifier's ranges, 10 dB or 20 dB apart.
[[nodiscard]] std::span<const UnitSlip> range_steps();

/// Of masses.
[[nodiscard]] std::span<const UnitSlip> mass_slips();

/// "1000: kN for N, mm for m, or mV for V; ...": units of channels of which one
/// is at least `least` and at most `most` times the other, or the other way
/// round, the nearest to their middle first; empty for none.
/// @param least, most above zero
[[nodiscard]] std::string units_between(double least, double most);

/// The unit or step of a range that a factor is to 5 %, as sensitivities are
/// known; empty for none.
/// @param factor above zero
[[nodiscard]] std::string channel_slip(double factor);

/// The same of masses.
[[nodiscard]] std::string mass_slip(double factor);

}  // namespace tapfit::acquisition
