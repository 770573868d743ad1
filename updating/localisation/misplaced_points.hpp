// Hit and sensor points that were not where they were written down: a grid
// read off wrongly, a direction the other way round.
//
// No effect on the structure. The FRFs of one point are predicted by a fit to
// all others; where they are far off at the grid that was written down, every
// other grid and direction of the model is tried in its place:
//
//   H_oi' = s^2 x_o' V_i',   x_o = H* e_o   (row i' of the base for any grid)
//
// A point is misplaced where the prediction fails there and holds elsewhere.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/localisation/misplaced.hpp"

#include <vector>

namespace tapfit::updating {

/// A misplaced point and the FRFs of the set that it has part in.
struct MisplacedPoint {
  Misplaced point;
  std::vector<std::size_t> frfs;  ///< ascending
};

enum class Looked {
  Roved,  ///< hit points, and sensor points that their channel moves on from
  All     ///< the points of sensors that stay as well
};

/// @param looked a channel that is wrong altogether may be swapped or have the
///   wrong sign: All only once effects have had their chance
/// @param fit to all FRFs
/// @param floor error that the measurement itself supports
/// @return the points found, the plainest first; most often none
[[nodiscard]] std::vector<MisplacedPoint> misplaced_points(
    const Fit& fit,
    const Fitter& fitter,
    double floor,
    Looked looked,
    const Progress& progress);

/// "hits at 12Z+ as written down, error 80 %: more likely at 14Z+, error 1.2
/// %".
[[nodiscard]] std::string describe(const Misplaced& point);

}  // namespace tapfit::updating
