// The few coordinates of a base that fits to measured pairs need.
//
// A base that can be asked about any grid holds modes to well above the band
// and answers of every point. An FRF between two points is as good where one of
// the two has its answer in the span (reciprocity), and what modes above the
// band leave is smooth: the span holds modes to a little above the band and,
// through the others (index H), what they answer
//
//   x = (Lambda_H - sigma)^-1 P_H,  sigma from 0 to the top of the band,
//   y = -K'_HH^-1 (K'_HL - lambda' M'_HL) phi',
//
// P the rows of the driven points, y what the modes phi' of properties at
// either end of their range need beyond the span. Of all these the directions
// that carry energy are kept.
//
// A base with released degrees of freedom holds the answer to each of them, and
// what moves in the band are few patterns of these. At one setting of the
// parameters and properties they are the modes phi' and the answers x there;
// from setting to setting the span takes what it lacks, in the energy of that
// setting, and the range of a parameter is halved until its middle lacks
// nothing.
// Source: R. R. Craig, A. J. Kurdila, "Fundamentals of Structural Dynamics",
// 2006, ch. 17 (residual flexibility); A. Quarteroni et al., "Reduced Basis
// Methods for Partial Differential Equations", 2016, ch. 6 and 7 (snapshots,
// greedy choice).
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct ReducedBase;

struct LeanOptions {
  double high_hz = 100.0;  ///< top of the band
  /// Largest change of ln factor of each uncertain property.
  std::vector<double> spread = {};
};

/// @param base K diagonal and ascending, M = I, without terms
/// @param driven r x points: the rows of V at driven points, as columns
/// @return r x fewer, orthonormal
[[nodiscard]] Eigen::MatrixXd lean_span(const ReducedBase& base,
                                        const Eigen::MatrixXd& driven,
                                        const LeanOptions& options);

/// The same of a base with terms, from `included` on over all their ranges.
/// @param driven with the points that are acted on
[[nodiscard]] Eigen::MatrixXd released_span(const ReducedBase& base,
                                            const Eigen::MatrixXd& driven,
                                            const LeanOptions& options);

}  // namespace tapfit::updating
