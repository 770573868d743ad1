// How slowly a response decays, octave by octave, each against its own noise.
//
// Hum, drift and noise of the whole channel hide the end of a decay that is
// quiet there where it is heard. As in room acoustics (ISO 3382) the response
// is therefore split into octaves, and the level
//
//   L(t) = ln rms(t) = L0 - a t
//
// of each is followed from its peak down to where it meets the quietest that is
// heard there, by a straight line through its last 20 dB. What hums or drifts
// does not fall and what is excited anew does not fall straight: neither is a
// decay.
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>

namespace tapfit::acquisition {

/// So many let what the block's end cuts off be exp(-6) = 0.25 % of a response.
inline constexpr double decayed_time_constants = 6.0;

struct OctaveDecay {
  double rate = 0.0;                     ///< a [1/s], > 0
  std::array<double, 2> octave_hz = {};  ///< where
};

/// The slowest decay that any octave in the band shows.
///
/// Octaves reach up to 0.3 of the sampling rate, and down to where the response
/// holds 200 samples of ten thirds of the octave's upper end. A decay must be
/// seen over 6 dB, 10 dB above the octave's quietest part; 60 dB below the
/// loudest, in time or among octaves, nothing counts.
///
/// @param response from the trigger to the end of the room, freed of its offset
/// @param band_hz octaves that it touches are looked at
[[nodiscard]] std::optional<OctaveDecay> slowest_decay(
    const Eigen::VectorXd& response,
    double sample_rate_hz,
    const std::array<double, 2>& band_hz);

}  // namespace tapfit::acquisition
