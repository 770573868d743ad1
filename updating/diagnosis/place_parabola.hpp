// How the likelihood of an effect falls off around its place, as a parabola
// through the places that were tried, and how its size goes with the place:
//
//   ln L(z) ~ c + g'z + 1/2 z'Hz,   ln p(z) ~ ln p + S z,
//   place ~ N(-H^-1 g, -H^-1),      var ln p = S (-H^-1) S'
//
// by least squares in which places far down the likelihood count little.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::updating {

/// What was fitted at one place.
struct TriedPlace {
  Eigen::Vector3d at;  ///< [m]
  double log_likelihood = 0.0;
  Eigen::VectorXd log_p;  ///< of the effect's own parameters
};

struct PlaceParabola {
  Eigen::MatrixXd axes;  ///< 3 x d, the directions told, a grid spacing long
  Eigen::VectorXd top;   ///< d, of the largest likelihood, in spacings
  Eigen::MatrixXd covariance;  ///< d x d, of the place
  Eigen::MatrixXd slope;       ///< parameters x d, d ln p / d z
};

/// @param tried the best among them
/// @return nothing where they are too few
[[nodiscard]] std::optional<PlaceParabola> parabola_through(
    const std::vector<TriedPlace>& tried, const TriedPlace& best);

/// Of the parameters' logarithms, for not knowing the place better.
[[nodiscard]] std::vector<double> size_deviations(const PlaceParabola& q);

}  // namespace tapfit::updating
