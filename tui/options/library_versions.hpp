// What the program is made with, for `tapfit --version` and whoever has to find
// out why two machines differ.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// The program itself, then libraries with the versions that are in use; of
/// those made of headers alone, the versions it was built with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
library_versions();

}  // namespace tapfit::tui
