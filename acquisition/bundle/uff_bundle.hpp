// A test bundle that is nothing but a universal file: time records of a hammer
// and of sensors (dataset 58 or 58b, function type 1), or FRFs (type 4).
//
// A run is one force record with the motions that stand next to it: a new one
// begins where the force, or a point and direction, comes a second time, or
// where length or sampling differ. The k-th sensor of each run counts as the
// same transducer, since a universal file does not say which one it was.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/uff/uff_function.hpp"

#include <filesystem>

namespace tapfit::acquisition {

/// The bundle in a universal file. With a force and motions in it, it is a
/// bundle of recordings (full scales are infinite unless an ID line declares
/// them, see uff_records.hpp); else one of ready FRFs. What is left out is in
/// the warnings.
///
/// @throws InputError when it holds neither
[[nodiscard]] TestBundle read_uff_bundle(const std::filesystem::path& path);

/// Sampling rate of a step [s] that was written with six digits: a whole number
/// where one lies within them [Hz].
[[nodiscard]] double whole_rate_of(double step);

/// Sampling rate of a time record: of its ID line, where that agrees with its
/// step, else whole_rate_of() the step [Hz].
[[nodiscard]] double rate_of(const UffHeader& header);

/// The samples of one run [SI], channels in the bundle's order; a channel that
/// has no place in the run is zero.
///
/// @param channels how many the bundle has
/// @throws InputError for a broken record, as MappedFile::reading
[[nodiscard]] Recording read_uff_run(const UffFile& file,
                                     const Run& run,
                                     std::size_t channels);

}  // namespace tapfit::acquisition
