// Hammer tests of plates given by their modes, written as bundles. Exact but
// for the noise (generated_structure.hpp).
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating::testing {

/// A test in memory; what is in it can be falsified.
struct SheetAndRecords {
  acquisition::TestBundle bundle;
  std::vector<acquisition::Recording> recordings;
  int bits = 24;  ///< the files are rounded to
};

struct PlainOptions {
  unsigned seed = 1;
  int sensors = 2;
  int runs = 8;
  bool held = false;             ///< else hung on soft strings
  std::vector<int> sensor_at{};  ///< points; empty: drawn by the seed
  double stiffer = 1.0;          ///< all frequencies times that
  double noise = 1.0;            ///< of the ordinary one
};

/// A clean test: random plate, sensors also hit (driving points), weighed.
[[nodiscard]] SheetAndRecords plain_test(const PlainOptions& options);

/// Writes test.json and the recordings as sound files.
void write_bundle(const SheetAndRecords& test,
                  const std::filesystem::path& folder);

}  // namespace tapfit::updating::testing
