// The few patterns of many released degrees of freedom that a test can see. A
// plate held on all sides has hundreds; with K and M of their constraint modes
// psi, S what springs of size p make of them, and b what drives them (the
// inertia of the base's motions in the band, unit forces at the points),
//
//   q = (K + p S - mu M)^-1 b
//
// from no spring to the stiffest, mu from 0 to the top of the band. Of all
// these the directions that carry energy are kept.
// Source: A. Quarteroni et al., "Reduced Basis Methods for Partial Differential
// Equations", 2016, ch. 6 and 7 (snapshots); M. P. Castanier, Y.-C. Tan, C.
// Pierre, "Characteristic constraint modes for component mode synthesis", AIAA
// Journal 39, 2001, p. 1182 (what a base does with them).
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

struct ReleasedMotions {
  Eigen::MatrixXd K;      ///< psi' K psi, q x q
  Eigen::MatrixXd M;      ///< psi' M psi, or what of it counts up to the top
  Eigen::MatrixXd loads;  ///< q x any: b, of motions and forces of unit energy
  double top = 0.0;       ///< of the band [rad^2/s^2]
};

/// Springs in place of what was released, and how stiff they may be.
struct ReleasedSprings {
  Eigen::MatrixXd S;  ///< q x q of a unit size
  double lower = 0.0;
  double upper = 0.0;
};

/// @return q x fewer
[[nodiscard]] Eigen::MatrixXd released_patterns(
    const ReleasedMotions& motions,
    const std::vector<ReleasedSprings>& springs);

}  // namespace tapfit::structure
