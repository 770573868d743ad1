// The room updating/virtual_test. Tests of structures that exist only in
// memory, with what is hidden in them.
// In:  A specification.
// Out: A bundle's folder, and truth.json for tests alone, or its seal.
// May include: its row in CONTRIBUTING.md.
//
// Makes a whole test bundle of a structure that exists only in memory:
// model.bdf, the recordings, test.json and, for tests alone, truth.json.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/foundation/progress.hpp"
#include "updating/virtual_test/virtual_spec.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What became of it, for a summary.
struct VirtualBundleResult {
  std::vector<double> model_hz;  ///< of the engineer's model, in the band
  std::vector<double> true_hz;
  std::vector<double> true_damping;
  std::size_t runs = 0;
  double seconds_per_run = 0.0;
  double rate_hz = 0.0;
  std::array<double, 2> band_hz{};
  std::uintmax_t bytes = 0;  ///< of the whole folder
};

/// The demo: two 20 g accelerometers with cables and a clamp that gives a
/// little, on the frame.
[[nodiscard]] VirtualBundleSpec demo_spec();

/// Makes the bundle; the same spec makes the same bytes.
///
/// @param folder made when it is not there; what else is in it stays
/// @param rule of the folder: its inputs, and whether other files may be
///   replaced. Without one no file is
/// @throws InputError for a file that the rule does not let, effects that do
///   not fit the structure, a deck without a band; Stopped. The folder is then
///   as it was
VirtualBundleResult make_virtual_bundle(
    const VirtualBundleSpec& spec,
    const std::filesystem::path& folder,
    const Progress& progress = {},
    const acquisition::OutputRule& rule = {});

}  // namespace tapfit::updating
