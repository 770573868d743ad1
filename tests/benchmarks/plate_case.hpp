// A cantilevered plate of any fineness with a made-up hammer test, ready to be
// solved whole or through its base.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/structure/solve/system.hpp"

#include <vector>

namespace tapfit::benchmarks {

struct PlateCase {
  structure::Deck deck;
  acquisition::TestBundle bundle;
  effects::TestContext context;
  structure::SparseMatrix K;  ///< over the free degrees of freedom
  structure::SparseMatrix M;
  std::vector<int> free;
  updating::ReducedBase base;  ///< holds the measured and the acted-on points
};

/// 0.30 m x 0.12 m x 3 mm aluminium, clamped along x = 0, six hits, two
/// sensors. Solved on the first call for a fineness and kept.
/// @param nx, ny shells along x and y; 6 nx (ny + 1) free degrees of freedom
[[nodiscard]] const PlateCase& plate_case(int nx, int ny);

/// Lines of the band with a little damping [rad/s].
[[nodiscard]] Eigen::VectorXcd band_lines(Eigen::Index count);

/// The bundle's pairs on these lines, FRFs still zero.
[[nodiscard]] signal::FrfSet measured_pairs(
    const acquisition::TestBundle& bundle, const Eigen::VectorXcd& s);

/// The model at the measured pairs on these lines.
[[nodiscard]] updating::FrfModel frf_model(const PlateCase& plate,
                                           const Eigen::VectorXcd& s);

/// A mass at each of the first `count` hit points [kg].
[[nodiscard]] updating::ModelState with_masses(const PlateCase& plate,
                                               std::size_t count,
                                               double mass);

}  // namespace tapfit::benchmarks
