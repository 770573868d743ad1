// Time records written to a universal file: dataset 58 with function type 1, as
// text (4E20.12) or binary (58b, little endian doubles).
//
// A run is its force record and the motions beside it, which is what
// read_uff_bundle() makes runs of. What a universal file has no field for
// stands in ID lines, from which it is read again: FULL SCALE (for overloads),
// BAND, and RATE, since record 7 holds the step with six digits only.
//
// Source: SDRC universal file format 58, revision 3, as kept by the University
// of Cincinnati.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

namespace tapfit::acquisition {

enum class UffEncoding { Text, Binary };

/// Writes one run: the hammer's record, then each sensor's, in SI.
///
/// @param recording of the run [SI]
/// @param number of its first record, from 1; counts on
void write_uff_run(const TestBundle& bundle,
                   const Run& run,
                   const Recording& recording,
                   UffEncoding encoding,
                   int& number,
                   std::ostream& out);

/// Header, then all runs; one recording is in memory at a time.
///
/// @throws InputError as read_recording; Stopped
void write_uff_records(const TestBundle& bundle,
                       UffEncoding encoding,
                       std::ostream& out,
                       const Progress& progress = {});

}  // namespace tapfit::acquisition
