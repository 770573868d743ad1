// The shape of a blow's top, which tells whether the force was cut off ahead of
// the recorder's filter.
//
// A conditioner that saturates ends the rise at once, and the filter behind it
// turns the two corners into ripple of some per cent: no two samples are equal.
// What stays is a level, and a shape that no smooth pulse has.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

struct PulseTop {
  double level = 0.0;  ///< median of the force above 90 % of its peak [N]
  double width = 0.0;  ///< between the 50 % points [samples]
  /// Share of that width which lies between the outermost 90 % points: 0.43 of
  /// a half sine, 0.41 of Hann's, t^4 has 0.67; of a half sine that is cut off
  /// and loses 1, 5 and 20 % of its impulse 0.50, 0.60 and 0.74.
  double flatness = 0.0;
  /// How far the force falls beside its top, in units of what it could at most
  /// were it a polynomial of degree 4 there: above 1 there are corners. A half
  /// sine has 0.4 at most, one cut off by 5 % 2 to 7 (behind a filter that
  /// rings only afterwards 0.3 where it is 12 samples long, 2 at 40).
  double corners = 0.0;
};

/// Measured between the samples where they are few.
///
/// @param force as of HammerSignal [N]
/// @param pulse one of it
/// @param noise standard deviation [N]
[[nodiscard]] PulseTop measure_top(const BaselineFree& force,
                                   const Pulse& pulse,
                                   double noise);

/// By how much a half sine with such a flatness would have lost force, and FRFs
/// are too large: impulse before over after the cut, less 1; 0 of one that is
/// not cut.
[[nodiscard]] double lost_force(double flatness);

}  // namespace tapfit::acquisition
