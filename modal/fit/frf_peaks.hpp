// Peaks of an FRF, and the one mode that each looks like.
//
// Near a resonance one pole p rules and the rest is almost constant,
//
//   H(s) = c + R / (s - p)
//   (s - s_0) H = (p - s_0) H + c (s - s_0) + d,   R = c (p - s_0) + d
//
// which is linear in p, c and d. Along s = sigma + j omega, H then runs round
// the circle about c + R / 2a with radius |R| / 2a, a = sigma - Re p: the
// Nyquist circle. The pole is that of the structure; sigma, the exponential
// window's damping, is in s and so not in p.
//
// Source: D. J. Ewins, "Modal testing", 2nd ed. 2000, section 4.3 (circle
// fit); the linear form as in J. Schoukens, R. Pintelon, "Identification of
// linear systems", 1991, ch. 4 (Levy's estimate, one pole).
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace tapfit::modal {

/// Lines whose |H| is the largest for at least that factor downhill on either
/// side, in rising order.
///
/// @param magnitude |H| per line
/// @param prominence at least 1; 2 leaves out ripples below 6 dB
[[nodiscard]] std::vector<Eigen::Index> peak_lines(
    const Eigen::VectorXd& magnitude, double prominence = 2.0);

/// Those of an FRF of which its scatter leaves no doubt: the truth is higher at
/// the line than in the valleys beside it wherever it is in the 95 % circles of
/// all lines at once. Ripples of noise are not.
[[nodiscard]] std::vector<Eigen::Index> peak_lines(const signal::Frf& frf);

/// One mode fitted to the lines around a peak.
struct PeakFit {
  std::complex<double> pole;     ///< [rad/s], Re < 0
  std::complex<double> residue;  ///< R [(m/s^2)/N rad/s]
  std::complex<double> rest;     ///< c [(m/s^2)/N]
  std::complex<double> centre;   ///< of the circle [(m/s^2)/N]
  double radius = 0.0;           ///< [(m/s^2)/N]
  Eigen::Index first = 0;        ///< lines it was fitted to ...
  Eigen::Index last = 0;         ///< ... this one included
  double deviation = 0.0;        ///< rms of what is left, over the radius

  [[nodiscard]] double frequency_hz() const;
  [[nodiscard]] double damping_ratio() const;
};

/// The stretch above 0.4 of the peak's magnitude, and no higher one; three
/// lines on either side at least where there are as many.
///
/// @param s, H per line of the FRF
/// @param peak line of the peak
/// @return empty for fewer than five lines, or where no damped pole fits, or
///   the one that does lies beside them
[[nodiscard]] std::optional<PeakFit> fit_peak(const Eigen::VectorXcd& s,
                                              const Eigen::VectorXcd& H,
                                              Eigen::Index peak);

}  // namespace tapfit::modal
