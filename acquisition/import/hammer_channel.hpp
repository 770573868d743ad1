// Which channel of a recording is the hammer.
#pragma once

#include "acquisition/instruments/time_record.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

struct HammerChoice {
  std::size_t channel = 0;  ///< index into the records
  std::string reason;       ///< "its unit, N", for a sentence
  bool certain = true;      ///< the file's unit says it
};

/// How far a record is to one side of its mean, and how seldom: the magnitude
/// of its third standardised moment,
///
///   |mean((x - m)^3)| / mean((x - m)^2)^1.5
///
/// Pulses that take a share p of the time have 1/sqrt(p); what rings is about
/// zero.
[[nodiscard]] double one_sidedness(const Eigen::VectorXd& values);

/// The channel in a unit of force; of several, and where there is none, the one
/// with the shortest pulses to one side (one_sidedness).
///
/// @param records at least one
[[nodiscard]] HammerChoice choose_hammer(
    const std::vector<const TimeRecord*>& records);

}  // namespace tapfit::acquisition
