// The recordings of a bundle one by one, from sound files or from the one
// universal file that all of them stand in.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/bundle/uff_bundle.hpp"

#include <optional>

namespace tapfit::acquisition {

/// A universal file is taken apart once, whatever the number of its runs.
class RunReader {
 public:
  /// @param bundle must outlive the reader
  /// @throws InputError where the bundle's universal file cannot be taken apart
  explicit RunReader(const TestBundle& bundle);

  /// Several threads may read at once.
  ///
  /// @throws InputError as read_recording()
  [[nodiscard]] Recording read(const Run& run) const;

 private:
  const TestBundle& bundle_;
  std::optional<UffFile> uff_;
};

/// Reads one run's sound file or its records of a universal file and scales
/// every channel to SI.
///
/// @throws InputError for a missing or unreadable file, a channel count that
///   differs from the bundle's, a sample that is not finite (with its time
///   and channel)
[[nodiscard]] Recording read_recording(const TestBundle& bundle,
                                       const Run& run);

/// All runs of the bundle, in order; they must agree in sampling rate.
[[nodiscard]] std::vector<Recording> read_recordings(const TestBundle& bundle);

}  // namespace tapfit::acquisition
