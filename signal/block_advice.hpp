// Whether responses die within the block, and what to do where they do not:
// a longer block or a narrower band, before any window.
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
#pragma once

#include "acquisition/hits.hpp"
#include "signal/hit_blocks.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::signal {

/// What is left at the block's end of all that was looked at.
struct Lasting {
  double time_constants = std::numeric_limits<double>::infinity();
  double rate = 0.0;  ///< of the decay that is slowest [1/s]
  double hz = 0.0;    ///< where
  double low_hz = std::numeric_limits<double>::infinity();
  double high_hz = 0.0;  ///< less than six time constants: low ... high
  /// What is heard and does not decay at all, 0 for nothing; it does not count
  /// among the above.
  double hum_hz = 0.0;

  [[nodiscard]] bool any() const { return high_hz > 0.0; }
  void join(const Lasting& other);
};

/// Looks at every sensor's response to the strongest hit of a run. Lines that
/// stand less than 15 dB out of the late half's median count as noise.
///
/// @param blocks of one run; no hits leave nothing to see
/// @param band_hz lines looked at
[[nodiscard]] Lasting lasting_response(const HitBlocks& blocks,
                                       const std::array<double, 2>& band_hz);

struct BlockAdvice {
  Lasting lasting;
  double block_s = 0.0;    ///< six time constants and the pre-trigger
  int accepted = 0;        ///< hits
  int with_room = 0;       ///< of these, hits that a block as long would fit
  bool every_run = false;  ///< each run with accepted hits has one with room
  double room_s = 0.0;     ///< the longest block that any of them has room for
  /// A band without what lasts, where it is at least half as wide.
  std::optional<std::array<double, 2>> band_hz;
};

/// @param samples length of each run's recording
/// @return empty where all that is seen decays by six time constants
[[nodiscard]] std::optional<BlockAdvice> advise_block(
    const Lasting& lasting,
    const acquisition::HitSet& hits,
    const std::vector<Eigen::Index>& samples,
    const std::array<double, 2>& band_hz);

/// The advice in words, and what the window costs instead.
///
/// @param sigma of the exponential window in use [1/s]; 0: none
[[nodiscard]] std::string statement(const BlockAdvice& advice, double sigma);

/// What to say of the hum; empty where there is none.
[[nodiscard]] std::string hum_statement(const Lasting& lasting);

/// Advice and hum in words, as far as there is something to say.
///
/// @param samples, band_hz as for advise_block()
/// @param sigma as for statement()
[[nodiscard]] std::vector<std::string> lasting_statements(
    const Lasting& lasting,
    const acquisition::HitSet& hits,
    const std::vector<Eigen::Index>& samples,
    const std::array<double, 2>& band_hz,
    double sigma);

}  // namespace tapfit::signal
