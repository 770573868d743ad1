// What is wrong with the test, as a list to read from top to bottom.
#pragma once

#include "acquisition/foundation/finding.hpp"
#include "tui/screen/screen.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::tui {

/// As many findings as fit, from the one given: severity, where and what, then
/// what it likely is and what to do. Says so while they are not known yet.
///
/// @param findings nullptr until the checks are through
/// @param first the finding at the top; the last one where there are fewer
void draw_findings(Screen& screen,
                   const Rect& rect,
                   const std::vector<Finding>* findings,
                   std::size_t first);

}  // namespace tapfit::tui
