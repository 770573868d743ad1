// The numbers of a function's data in a universal file, as text or as bytes.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_datasets.hpp"

#include <string_view>
#include <vector>

namespace tapfit::acquisition {

/// Four or eight bytes of IEEE 754, whatever the machine's own order.
[[nodiscard]] double uff_single(const char* at, bool big_endian);
[[nodiscard]] double uff_double(const char* at, bool big_endian);

/// Adds the numbers of a data line.
///
/// @param number of the line, from 1 on, for messages
/// @throws InputError for a line that holds something else
void take_uff_line(const UffDataset& dataset,
                   std::string_view line,
                   int number,
                   bool is_double,
                   std::vector<double>& values);

/// The error for a function with fewer numbers than it announces.
[[nodiscard]] InputError uff_cut_off(const UffDataset& dataset,
                                     std::size_t there,
                                     std::size_t wanted);

}  // namespace tapfit::acquisition
