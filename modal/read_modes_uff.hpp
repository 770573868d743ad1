// Modes out of universal files: datasets 55 and 2414, real and complex.
//
// Record 6 of a dataset 55, record 9 of a 2414, says how the eigenvalue stands
// in the file:
//   2  normal mode: frequency, modal mass, viscous damping ratio
//   3  complex eigenvalue: lambda, modal A, modal B
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "modal/mode_set.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::modal {

struct UffModes {
  /// Degrees of freedom: those at which some mode moves. Scaled to unit modal
  /// mass where every mode has a modal mass (or modal A) other than zero;
  /// else the shapes are as in the file. No uncertainties.
  ModeSet set;
  std::vector<std::string> skipped;  ///< what was not read, and why
};

/// Reads the modes of a universal file, by frequency. Static results,
/// datasets at elements and those of stresses or the like are skipped and
/// named; modes at 0 Hz (rigid) are kept.
///
/// @throws InputError for a missing file, a broken record (with its line), a
///   file without any mode
[[nodiscard]] UffModes read_modes_uff(const std::filesystem::path& file);

/// As above, from memory.
/// @param name the source's name, for messages
[[nodiscard]] UffModes read_modes_uff_text(const std::string& text,
                                           const std::string& name);

}  // namespace tapfit::modal
