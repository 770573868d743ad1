// The accepted hits of one run, cut out, freed of offset and windowed: what
// the transforms start from.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "signal/spectra/block_tail.hpp"
#include "signal/spectra/noise_spectrum.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

struct HitBlocks {
  double dt = 0.0;             ///< sampling interval [s]
  Eigen::Index trigger = 0;    ///< row at which t = 0
  Eigen::Index force_end = 0;  ///< rows from here on are zero in `force`
  Eigen::MatrixXd force;       ///< block x hits [N], pulse window applied
  /// Per sensor of the run: block x hits [SI], zero before the hit begins.
  std::vector<Eigen::MatrixXd> responses;
  Eigen::VectorXd force_power;       ///< block, mean over hits of window^2
  Eigen::VectorXd response_power;    ///< block, mean over hits of window^2
  NoiseSpectrum force_noise;         ///< before the hits
  std::vector<NoiseSpectrum> noise;  ///< per sensor, before the hits
  /// Whether something precedes the hits that tells the channels' noise. If
  /// not, a sensor's is what neighbouring samples differ by where they differ
  /// least, which ringing only adds to. The force's is left at nothing: few of
  /// its samples are within the pulse, and their noise is common to many lines.
  bool quiet = true;
  /// Per sensor, behind the blocks' end; empty: nothing is known of it.
  std::vector<BlockTail> tails;
};

struct BlockOptions {
  bool force_window = true;
  double lowest_hz = 0.0;  ///< lowest frequency of interest, above 0
  /// Poles of modes that outlast a block [rad/s]; may be empty. Their ringing
  /// from earlier hits is taken off, their decay behind the block's end found.
  Eigen::VectorXcd lasting_poles;
};

/// Cuts and prepares the accepted hits of one run.
///
/// Offsets are those at each hit (signal/spectra/offset.hpp). Samples that a
/// hit lacks because the file begins or ends within its block are zero.
///
/// @return blocks with no columns when no hit is accepted
/// @throws InputError when the force of an accepted hit is zero throughout
[[nodiscard]] HitBlocks cut_hits(const acquisition::Run& run,
                                 const acquisition::Recording& recording,
                                 const acquisition::HitSet& hits,
                                 const std::vector<acquisition::Hit>& run_hits,
                                 const BlockOptions& options);

}  // namespace tapfit::signal
