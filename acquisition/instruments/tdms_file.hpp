// Channels of a TDMS file as arrays "Group/Channel", their properties as
// "Group/Channel@wf_increment" and so on.
#pragma once

#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::acquisition {

/// Whether it begins as a TDMS file, or the index of one, does.
[[nodiscard]] bool is_tdms(const std::filesystem::path& file);

/// @throws InputError as read_tdms_segments and apply_tdms_scales, for an index
///   in place of the file, for more samples than memory holds
[[nodiscard]] std::vector<NamedArray> read_tdms_arrays(
    const std::filesystem::path& file);

}  // namespace tapfit::acquisition
