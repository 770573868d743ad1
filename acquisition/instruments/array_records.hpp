// Which arrays of a file are records of channels, and what the file says of
// them: names, units, sensitivities, points, sampling rate.
//
//   Testlab      a structure with x_values.increment, y_values.values,
//                y_values.quantity.label and function_record.name
//   rattlesnake  time_data, and a group channels with a list for each column
//                of its table of channels
//   any other    the longest arrays; what else there is by usual names
//                (usual_names.hpp), as in the exports of Dewesoft (Sample_rate,
//                Data1_NAME), in TDMS (wf_increment, unit_string), numpy and
//                HDF5
#pragma once

#include "acquisition/instruments/time_record.hpp"
#include "acquisition/readers/named_array.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Those of one recording. Names are different from each other. Millivolts are
/// made volts.
///
/// @return empty where there are none
[[nodiscard]] std::vector<TimeRecord> records_of_arrays(
    const std::vector<NamedArray>& all);

/// Whether an array of other arrays may be a record, by its name and values.
[[nodiscard]] bool is_record_array(const std::vector<NamedArray>& all,
                                   const NamedArray& array);

}  // namespace tapfit::acquisition
