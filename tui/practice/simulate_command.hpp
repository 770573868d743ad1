// tapfit simulate OUT_FOLDER: a hammer test of a structure that exists only in
// memory, with an effect hidden in it, for practice and for tests.
#pragma once

#include "acquisition/foundation/progress.hpp"

namespace tapfit::tui {

/// Reads its own command line (argv[0] is "simulate"), makes the bundle and
/// prints a short summary on standard output.
///
/// @return exit status: 0 done, 2 the command line is at fault (said on
///   standard error)
/// @throws InputError, Stopped
int simulate_command(int argc,
                     const char* const* argv,
                     const Progress& progress);

}  // namespace tapfit::tui
