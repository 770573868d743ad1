// Variance of an FRF from the scatter of its hits and the noise before them.
//
//   var H = R / Gff,   R = noise power per hit and line
//
// What is known beforehand of R: noise of the channels before the hits, sent
// through the same windows, and hits that repeat only to a share b of their
// response (place, direction):
//
//   P = Ny sum w^2 + |H|^2 Nf sum wf^2 + b |H|^2 Gff / m
//
// What the hits say: R = sum_k |Y_k - H F_k|^2 / (m - 1), by way of
// Gyy - 2 Re(conj(H) Gyf) + |H|^2 Gff, which is the
// linearised jackknife and, for two hits, the formula with coherence
// |H|^2 (1 - g^2) / (2 m g^2) without its bias. From few hits that is a
// chi-squared number with 2 (m - 1) degrees of freedom per line, so the ratio
// R / P is averaged over so many neighbouring lines that about 24 degrees of
// freedom come together (as many on one side at the band's ends); P keeps the
// shape over the resonances. A blow askew brings in another direction's
// response, which is not small where this one's is, so that R / P may span
// decades: its logarithm is averaged first, and P mended by that, so that what
// stands out at one line is not lent to all others.
//
// Sources: B. Efron, "The jackknife, the bootstrap and other resampling
// plans", SIAM 1982; J. S. Bendat, A. G. Piersol, "Random Data", ch. 9.
#pragma once

#include "signal/estimate/estimator.hpp"
#include "signal/spectra/line_noise.hpp"

#include <Eigen/Core>

namespace tapfit::signal {

/// E|dH|^2 per line; above zero and finite wherever H is.
///
/// A single hit has no scatter: its variance is that of the noise alone and
/// knows nothing of how well the hits repeat.
///
/// @param s lines [rad/s], ascending imaginary part
/// @param powers sums over the hits, per line
/// @param H estimate, lines
[[nodiscard]] Eigen::VectorXd frf_variance(const Eigen::VectorXcd& s,
                                           const CrossPowers& powers,
                                           const Eigen::VectorXcd& H,
                                           const LineNoise& noise);

/// Degrees of freedom that frf_variance() has from so many hits.
[[nodiscard]] double variance_freedom(int hits);

}  // namespace tapfit::signal
