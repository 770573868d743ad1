// tapfit score: makes practice cases, diagnoses them and says how often the
// diagnosis was right. The cases can be spread over machines by shards and the
// parts merged.
#pragma once

#include "acquisition/foundation/progress.hpp"

namespace tapfit::tui {

/// Reads its own command line (argv[0] is "score") and prints.
///
/// @return exit status 0, or 2 where the command line is at fault
/// @throws InputError, Stopped
int score_command(int argc, const char* const* argv, const Progress& progress);

}  // namespace tapfit::tui
