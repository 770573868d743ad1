// tapfit challenge -o FOLDER: a hammer test that hides something under a seal,
// to be found in the terminal. tapfit reveal opens the seal.
#pragma once

#include "acquisition/foundation/progress.hpp"

namespace tapfit::tui {

/// Reads its own command line (argv[0] is "challenge"), makes the bundle and
/// says on standard output how to play it.
///
/// @return exit status: 0 done, 2 the command line is at fault (said on
///   standard error)
/// @throws InputError also where anything is in the way; Stopped
int challenge_command(int argc,
                      const char* const* argv,
                      const Progress& progress);

}  // namespace tapfit::tui
