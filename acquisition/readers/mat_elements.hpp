// Whether a MATLAB file holds what it announces, before matio is asked: that
// makes room for any length it is told, leaves zeros where a file ends early,
// and does not see that packed numbers are damaged.
//
// Source: "MAT-File Format", The MathWorks, 2019.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/progress.hpp"

#include <filesystem>
#include <string>

namespace tapfit::acquisition {

/// What to say of a file that is none, or of a kind that is not read.
[[nodiscard]] InputError no_mat_file(const std::filesystem::path& file);

/// Whether it is of version 7.3, which is HDF5 behind a header of MATLAB's.
[[nodiscard]] bool mat_is_hdf5(const std::filesystem::path& file);

/// Compares all lengths within a file with what is there, and the checksums of
/// what is packed. Files of version 7.3 are HDF5,
/// which is read by a process of its own (own_process.hpp).
///
/// @param progress asked whether to go on
/// @throws InputError with the byte where it ends early or is damaged, and
///   where memory does not hold all its numbers; Stopped
void check_mat_elements(const std::filesystem::path& file,
                        const Progress& progress = {});

}  // namespace tapfit::acquisition
