// What of a response is left at the end of its block: how slowly it decays,
// what hums, and what is excited anew.
//
// The response of the strongest hit is looked at in two halves of the block
// behind the trigger, T/2 each, both under a Hann window. At the line of a mode
// that decays with the rate a
//
//   |Y_late| / |Y_early| = exp(-a T/2)
//
// (the windows are the same, and the mode's phase does not count), so that the
// mode has a T = 2 ln(|Y_early| / |Y_late|) time constants in the block. With
// six what the block's end cuts off is exp(-6) = 0.25 % of it. An exponential
// window takes that away, too, but widens each resonance by sigma / pi in Hz.
//
// A structure that wind, machines or people excite between the blows is louder
// late in the block than its decay leaves it, and the halves tell of neither.
// The decay is then fitted along with it (signal/decay/segment_decay.hpp), and
// counts as too slow only where it surely is.
#pragma once

#include "signal/spectra/hit_blocks.hpp"

#include <array>
#include <limits>

namespace tapfit::signal {

/// A response that does not die because it is excited anew.
struct Excited {
  double hz = 0.0;          ///< 0: none
  double after_s = 0.0;     ///< behind the blow; 0: throughout
  double over_noise = 0.0;  ///< power, late in the block
};

/// What is left at the block's end of all that was looked at.
struct DecayCheck {
  double time_constants = std::numeric_limits<double>::infinity();
  double rate = 0.0;  ///< of the decay that is slowest [1/s]
  double hz = 0.0;    ///< where
  double low_hz = std::numeric_limits<double>::infinity();
  double high_hz = 0.0;  ///< less than six time constants: low ... high
  /// What is heard and does not decay at all, 0 for nothing; it does not count
  /// among the above.
  double hum_hz = 0.0;
  Excited excited{};  ///< where it stands highest out of the noise

  [[nodiscard]] bool any() const { return high_hz > 0.0; }
  void join(const DecayCheck& other);
};

/// Looks at every sensor's response to the strongest hit of a run. Lines that
/// stand less than 15 dB out of the late half's median count as noise.
///
/// @param blocks of one run; no hits leave nothing to see
/// @param band_hz lines looked at
[[nodiscard]] DecayCheck check_decay(const HitBlocks& blocks,
                                     const std::array<double, 2>& band_hz);

}  // namespace tapfit::signal
