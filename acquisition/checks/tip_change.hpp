// Blows that last longer, or shorter, from one run on: another tip, or another
// hammer. A blow is close to a half sine of length T, whose spectrum is
//
//   |F(f)| = F(0) |cos(pi f T)| / |1 - (2 f T)^2|
//
// Points differ in how they give, too, but not in the order in which they are
// hit.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::acquisition {

struct TipChange {
  std::size_t first = 0;  ///< run from which on blows are others
  double before_s = 0.0;  ///< median over the runs, between 10 % points
  double after_s = 0.0;
};

/// The change that parts the runs most clearly: all blows after it last three
/// tenths longer than all before, or all before longer than all after, as
/// medians of runs.
/// @return none with fewer than five runs, or two on either side
[[nodiscard]] std::optional<TipChange> tip_change(const HitSet& hits);

/// How much less force there is at a frequency, in dB, than with a blow of the
/// other length; without the spectrum's zeros.
/// @param length_s, other_s between 10 % points
[[nodiscard]] double force_lost_db(double hz, double length_s, double other_s);

/// A warning where ten dB are lost at the end of the band, else a note.
[[nodiscard]] std::vector<Finding> tip_change_findings(const TestBundle& bundle,
                                                       const HitSet& hits);

}  // namespace tapfit::acquisition
