// What a second blow costs a hit.
//
// A second pulse that is measured is part of the force, F = F_1 + F_2, and
// Y = H F holds for both together. It costs something in two ways:
//
//   force     |F_1 + F_2| dips where the pulses meet in opposite phase. Lines
//             there are as uncertain as those of a blow that is weaker or
//             softer by as much.
//   response  what the second pulse sets off has less of the block left: of
//             the whole response the share
//               p_2 / (p_1 + p_2) exp(-a (T - t_2))
//             lies behind the block's end T. A block that ends before single
//             blows' responses do is completed from its later half
//             (signal/spectra/block_tail.hpp): what began in its earlier half
//             costs no more than these.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"
#include "acquisition/hits/hits.hpp"

#include <array>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// A hit's block and what is asked of it.
struct JudgedBlock {
  Eigen::Index end = 0;  ///< the sample behind it
  double sample_rate_hz = 0.0;
  std::array<double, 2> band_hz = {};
  ResponseDecay decay;
};

/// @param others second_pulses() of the hit's block
/// @return what the largest of them is and what they all cost; empty where
///   there is none
[[nodiscard]] std::optional<SecondPulse> judge_second_pulses(
    const HammerSignal& hammer,
    const Pulse& main,
    const std::vector<Pulse>& others,
    const JudgedBlock& block);

/// How many double hits were kept and rejected, and what they cost; empty
/// without any.
[[nodiscard]] std::vector<std::string> double_statements(const HitSet& hits);

}  // namespace tapfit::acquisition
