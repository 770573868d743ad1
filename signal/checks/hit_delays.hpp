// How late each hit's response comes against the other hits of its placement.
// The structure is the same for all of them, so that
//
//   H_k(omega) = g_k R(omega) exp(-j omega tau_k) + e_k
//
// with one R for all: what is turned by a line through the origin of omega is a
// delay. R, the factors g_k and tau_k are those of least squares, each line
// counted by what its noise and usual scatter from hit to hit let expect. R
// takes up one delay, so that tau_k are relative to their mean.
//
// A structure that is another one from hit to hit (warmth, play, friction)
// turns phases near its resonances only. Its lines move along omega, by amounts
// of their own in each part b of the band,
//
//   H_k = g_k R + eps_kb omega dR/domega,   eps_kb real,
//
// and this then explains more than delays do.
//
// Source: the phase slope of a cross spectrum as a delay is that of A. G.
// Piersol, "Time delay estimation using phase data", IEEE Trans. Acoust. Speech
// Signal Process. 29(3), 1981.
#pragma once

#include "signal/checks/group_spectra.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace tapfit::signal {

/// One sensor's FRF of each hit.
struct HitFrfs {
  Eigen::VectorXd omega;     ///< lines [rad/s]
  Eigen::MatrixXcd H;        ///< lines x hits [response unit/N]
  Eigen::MatrixXd variance;  ///< lines x hits, E|dH|^2 by noise and scatter
  double alike = 1.0;        ///< neighbouring lines that share their noise
};

[[nodiscard]] HitFrfs hit_frfs(const GroupSpectra& of, std::size_t sensor);

struct HitDelayOptions {
  double most_s = 0.05;  ///< delays are looked for within plus and minus this
  /// Delays that differ by no more than this at a first look are not looked at
  /// any closer [s].
  double slight_s = 0.0;
  Eigen::Index parts = 8;  ///< of the band, each knowing as much of a delay
};

struct HitDelays {
  Eigen::VectorXd delay_s;  ///< per hit; positive: the response comes later
  Eigen::VectorXd sd_s;     ///< as the lines scatter
  Eigen::VectorXd alike;    ///< per hit, share of |H|^2 that g R explains, 0..1
  double before = 0.0;      ///< sum of |e|^2 over its variance without delays
  double after = 0.0;       ///< with them
  double moved = 0.0;       ///< what moved lines explain of `before`
  double expected = 0.0;    ///< of `after`, by noise and usual scatter
  Eigen::MatrixXd parts_s;  ///< parts x hits, what each would add to delay_s
  Eigen::MatrixXd parts_sd_s;
};

/// @return delays of zero and nothing else where none is worth a closer look
[[nodiscard]] HitDelays hit_delays(const HitFrfs& of,
                                   const HitDelayOptions& options);

}  // namespace tapfit::signal
