// The recordings of a bundle, of which some may be of no use: a file that is
// damaged, or a run without any hit, is no reason not to look at the others.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/hits.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// What becomes of a bundle with runs that cannot be used.
enum class Unreadable { Refused, LeftOut };

/// A run that cannot be used.
struct LeftOut {
  std::size_t run = 0;  ///< counted from 0
  InputError why;       ///< the file, what is wrong with it, what to try
};

/// "run 3 is left out: FILE: ...".
[[nodiscard]] std::string statement(const LeftOut& left_out);

struct ReadableRecordings {
  std::vector<Recording> recordings;  ///< of one that was not read: no samples
  std::vector<LeftOut> left_out;      ///< in the order of the runs
};

/// Whether the recordings that test.json names are there. One that is not is
/// refused, or only where none of them is.
///
/// @throws InputError with the place of the first in test.json
void check_run_files(const TestBundle& bundle, Unreadable missing);

/// All runs in order; left out are those that cannot be read, and those whose
/// sampling rate is not that of the first one which can.
///
/// @throws InputError where none can be read
[[nodiscard]] ReadableRecordings read_readable(const TestBundle& bundle);

/// As find_hits(), with no hit in runs that are left out; those in which none
/// is found are, too, and keep their samples.
///
/// @throws InputError as find_hits(); for want of hits only where no run has
/// one
[[nodiscard]] HitSet find_readable_hits(const TestBundle& bundle,
                                        ReadableRecordings& recordings,
                                        const HitOptions& options);

}  // namespace tapfit::acquisition
