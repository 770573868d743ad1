// The room acquisition/import. A test bundle made of tables of samples.
// In:  Files of time records of any kind, and what the user says of their
//      channels.
// Out: A folder with test.json and one sound file per table.
// May include: its row in CONTRIBUTING.md.
//
// Makes a test bundle out of files of samples
// (acquisition/import/read_time_table.hpp): test.json and one sound file for
// each run.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"
#include "acquisition/import/import_options.hpp"

namespace tapfit::acquisition {

/// Refuses what can be told before any file is read.
/// @throws InputError for a file that is not there, a bundle that is
void check_import(const ImportOptions& options);

/// Writes the bundle, reads it back (so that it is checked like any other) and
/// returns it, with a warning for each column that is zero throughout, each
/// rate that a column of times gave and that was rounded, and times that are no
/// seconds. The
/// samples keep every digit: 64-bit WAV, scaled by a power of two that leaves
/// room above the largest value.
///
/// @throws InputError for a file that is not there, what read_time_table
///   refuses, uneven sampling, a rate that is no whole number of Hz (sound
///   files cannot say it), an unknown unit, a bundle that is there already, a
///   sound file that is without `force`; Stopped. The folder is then as it was
TestBundle import_recordings(const ImportOptions& options,
                             const Progress& progress = {});

}  // namespace tapfit::acquisition
