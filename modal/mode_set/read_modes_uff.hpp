// Modes out of universal files: datasets 55 and 2414, real and complex.
//
// A normal mode has a frequency, a damping ratio and a modal mass, a complex
// one its eigenvalue and modal A; see acquisition/uff/uff_shapes.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::modal {

struct UffModes {
  /// Degrees of freedom: those at which some mode moves and every one has a
  /// value. Scaled to unit modal
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
