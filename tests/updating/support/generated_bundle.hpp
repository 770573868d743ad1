// Hammer tests of structures given by their modes, written as bundles. Exact
// but for the noise (generated_structure.hpp).
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "tests/updating/support/hidden_effect.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating::testing {

/// A test in memory; what is in it can be falsified.
struct SheetAndRecords {
  acquisition::TestBundle bundle;
  std::vector<acquisition::Recording> recordings;
  int bits = 24;  ///< the files are rounded to
};

/// The free ones are hung on soft strings.
enum class Structure { FreePlate, HeldPlate, FreeBeam, ClampedBeam, Storeys };

struct PlainOptions {
  Structure structure = Structure::FreePlate;
  unsigned seed = 1;
  int sensors = 2;
  int runs = 8;
  std::vector<int> sensor_at{};  ///< points; empty: drawn by the seed
  double stiffer = 1.0;          ///< all frequencies times that
  double noise = 1.0;            ///< of the ordinary one
  HiddenEffect hidden{};         ///< in the structure
};

/// A clean test: drawn at random, sensors also hit (driving points), weighed.
[[nodiscard]] SheetAndRecords plain_test(const PlainOptions& options);

/// Writes test.json and the recordings as sound files.
void write_bundle(const SheetAndRecords& test,
                  const std::filesystem::path& folder);

}  // namespace tapfit::updating::testing
