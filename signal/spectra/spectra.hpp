// The room signal/spectra. From hits to spectra: blocks cut out, freed of
// offset and of what still rings, windowed, transformed.
// In:  Recordings, hits and a plan of windows.
// Out: Per run the transforms of force and responses of each hit, and the
//      channels' noise on the same lines.
// May include: its row in CONTRIBUTING.md.
//
// Transforms of a run's blocks, on FFT lines or anywhere in the s-plane:
//
//   X(s) = sum_n x_n exp(-s t_n),   t = 0 at the trigger
//
// without the factor dt, which cancels in response / force; so does the phase
// of FFT lines, which counts from the block's begin. Responses include what
// follows behind the block where that is known (signal/spectra/block_tail.hpp).
#pragma once

#include "signal/spectra/fft.hpp"
#include "signal/spectra/hit_blocks.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

struct Spectra {
  Eigen::MatrixXcd force;                   ///< lines x hits
  std::vector<Eigen::MatrixXcd> responses;  ///< per sensor, lines x hits
};

/// The hits of several runs of one placement side by side, on the same lines.
[[nodiscard]] Spectra side_by_side(std::vector<Spectra> runs);

/// The FFT lines [first, last] with one exponential window.
///
/// @param fft of the blocks' length, planned once for all
/// @param sigma decay of the window [1/s]
[[nodiscard]] Spectra fft_spectra(const HitBlocks& blocks,
                                  const RealFft& fft,
                                  double sigma,
                                  Eigen::Index first,
                                  Eigen::Index last);

/// Any points s, as a product of exp(-s t) with the blocks. Samples at which
/// every line's window has fallen below 1e-12 are left out.
///
/// @param s complex angular frequencies [rad/s], Re(s) >= 0
[[nodiscard]] Spectra spectra_at(const HitBlocks& blocks,
                                 const Eigen::VectorXcd& s);

}  // namespace tapfit::signal
