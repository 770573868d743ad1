// Arrays out of MATLAB files, by way of matio (included only here).
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::acquisition {

/// All variables of a file, of any version. Fields of structures and elements
/// of cells are arrays of their own: "run.acc" (of several elements
/// "run(2).acc" and so on), "names{1}"; a cell of texts is one list of texts.
///
/// @throws InputError for a file that is none or is damaged, for a variable
///   that memory does not hold; Stopped
[[nodiscard]] std::vector<NamedArray> read_mat_arrays(
    const std::filesystem::path& file, const Progress& progress = {});

/// The version of matio that is in use.
[[nodiscard]] std::string matlab_library();

}  // namespace tapfit::acquisition
