// Corrections of a test that comes as a universal file: channels and runs are
// made up, so that what is wrong is said by the points that the file has.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// Whether runs and channels of the bundle stand in no test.json.
[[nodiscard]] bool is_without_sheet(const acquisition::TestBundle& bundle);

/// "FRFs hit at 28Z+ -> 30Z+", "FRFs measured at 36Z- -> 33Z-", where the
/// sensor was right in other runs "FRFs measured at 36Z- -> 33Z-, hit at 28Z+,
/// 6Z+", and of channels "FRFs of 12Z: times 0.102", ": other sign" or ":
/// velocity, not acceleration". Of many points or channels the first and the
/// last. "records" of a file of time records.
///
/// @param before, after of the same runs and channels
[[nodiscard]] std::vector<std::string> point_edits(
    const acquisition::TestBundle& before,
    const acquisition::TestBundle& after);

}  // namespace tapfit::effects
