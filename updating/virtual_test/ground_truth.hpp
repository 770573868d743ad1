// truth.json beside a virtual test: what was built in, for tests alone. Or the
// same as a seal (updating/virtual_test/truth_seal.hpp), for people who play.
#pragma once

#include "updating/virtual_test/made_files.hpp"
#include "updating/virtual_test/truth_seal.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_spec.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <filesystem>

namespace tapfit::updating {

/// Which of the two files holds it.
[[nodiscard]] inline const char* truth_file_of(const VirtualBundleSpec& spec) {
  return spec.sealed ? seal_file : truth_file;
}

/// Lists the files of its folder, too (updating/virtual_test/made_files.hpp):
/// to be written last.
///
/// @param truth of the first run (with roving sensors the masses move)
/// @throws InputError when the file cannot be written
void write_ground_truth(const VirtualBundleSpec& spec,
                        const VirtualSetup& setup,
                        const VirtualStructure& structure,
                        const ReducedTruth& truth,
                        double modulus_factor,
                        const std::filesystem::path& file);

}  // namespace tapfit::updating
