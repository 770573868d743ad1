// Words for one line: what matters most is to be read on the narrowest screen,
// and no number is cut.
#pragma once

#include <string>
#include <vector>

namespace tapfit::tui {

/// The first of the wordings, the longest first, that fits into so many
/// cells; else the last.
[[nodiscard]] std::string fitting(const std::vector<std::string>& wordings,
                                  int width);

/// "a, b, +3": as many of the items as fit, and how many do not.
[[nodiscard]] std::string listed(const std::string& heading,
                                 const std::vector<std::string>& items,
                                 const std::string& separator,
                                 int width);

}  // namespace tapfit::tui
