// Operational calibration: a known mass that hangs free is hit, and its
// accelerance has to be 1 / m.
//
//   A(s) = (g / m) exp(-s tau)
//
// g is the ratio of the sensor's to the hammer's true over assumed sensitivity,
// tau the delay of the sensor's channel against the hammer's. Both are fitted
// to the lines, weighted with their variances.
//
// Source: ISO 7626-1:2011, 6.2 (operational calibration); D. J. Ewins, "Modal
// testing", 2nd ed. 2000, 3.11.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <vector>

namespace tapfit::signal {

struct Calibration {
  std::size_t frf = 0;   ///< index into the set
  double gain = 1.0;     ///< g, below zero where the polarity is turned
  double gain_sd = 0.0;  ///< from the deviation of the lines
  double delay_s = 0.0;
  double delay_sd = 0.0;
  /// Root mean square of A m / (g exp(-s tau)) - 1: how little it is a mass.
  double deviation = 0.0;
};

/// One per FRF with any value, in the set's order.
///
/// @param mass_kg of the body with all that is fixed to it, above zero
/// @throws InputError for a mass that is not above zero
[[nodiscard]] std::vector<Calibration> calibrate(const FrfSet& set,
                                                 double mass_kg);

}  // namespace tapfit::signal
