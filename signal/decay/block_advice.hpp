// The room signal/decay. How responses decay towards their block's end, and
// what to do where they outlast it.
// In:  The blocks of each run.
// Out: Decay per run and, in words, a longer block or a narrower band.
// May include: its row in CONTRIBUTING.md.
//
// Whether responses die within the block, and what to do where they do not:
// a longer block or a narrower band, before any window.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "signal/decay/decay_check.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::signal {

struct BlockAdvice {
  DecayCheck lasting;
  double block_s = 0.0;    ///< six time constants and the pre-trigger
  int accepted = 0;        ///< hits
  int with_room = 0;       ///< of these, hits that a block as long would fit
  bool every_run = false;  ///< each run with accepted hits has one with room
  double room_s = 0.0;     ///< the longest block that any of them has room for
  /// A band without what lasts, where it is at least half as wide.
  std::optional<std::array<double, 2>> band_hz;
};

/// @param samples length of each run's recording
/// @return empty where all that is seen decays by six time constants, or nearly
[[nodiscard]] std::optional<BlockAdvice> advise_block(
    const DecayCheck& lasting,
    const acquisition::HitSet& hits,
    const std::vector<Eigen::Index>& samples,
    const std::array<double, 2>& band_hz);

/// The advice in words, and what the window costs instead.
///
/// @param sigma of the exponential window in use [1/s]; 0: none
[[nodiscard]] std::string statement(const BlockAdvice& advice, double sigma);

/// What to say of the hum; empty where there is none.
[[nodiscard]] std::string hum_statement(const DecayCheck& lasting);

/// What to say of what is excited anew; empty where nothing is.
[[nodiscard]] std::string excited_statement(const DecayCheck& lasting);

/// Advice, hum and excitation in words, as far as there is something to say.
///
/// @param samples, band_hz as for advise_block()
/// @param sigma as for statement()
[[nodiscard]] std::vector<std::string> lasting_statements(
    const DecayCheck& lasting,
    const acquisition::HitSet& hits,
    const std::vector<Eigen::Index>& samples,
    const std::array<double, 2>& band_hz,
    double sigma);

}  // namespace tapfit::signal
