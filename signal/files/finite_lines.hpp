// Takes values that are no finite numbers out of FRFs that came from a file.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <string>
#include <vector>

namespace tapfit::signal {

/// Leaves out FRFs with a bad value on a line that most others have: the line
/// would be taken out of all of them, and leave a gap. Lines at the ends of the
/// band leave none.
///
/// @return what to say of each that is left out
[[nodiscard]] std::vector<std::string> leave_out_broken(FrfSet& set);

/// Takes lines on which any FRF is not finite (often the one at 0 Hz) out of
/// all FRFs.
///
/// @return how many lines of which FRF; empty where all are finite
[[nodiscard]] std::string drop_bad_lines(FrfSet& set);

}  // namespace tapfit::signal
