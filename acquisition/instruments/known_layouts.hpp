// Files whose arrays mean something by their places: what Simcenter Testlab
// exports to MATLAB, and what rattlesnake streams to netCDF4.
//
// Sources: the fields of exported structures, as people's scripts read them;
// the source of sandialabs/rattlesnake-vibration-controller, version 3, module
// "streaming".
#pragma once

#include "acquisition/instruments/time_record.hpp"
#include "acquisition/readers/named_array.hpp"

#include <vector>

namespace tapfit::acquisition {

[[nodiscard]] bool is_testlab(const std::vector<NamedArray>& all);

/// Records of time alone: functions over other axes than seconds are none.
[[nodiscard]] std::vector<TimeRecord> testlab_records(
    const std::vector<NamedArray>& all);

[[nodiscard]] bool is_rattlesnake(const std::vector<NamedArray>& all);

/// Named as rattlesnake names channels: type, node and direction. Sensitivities
/// are mV per unit there; the values are in units.
[[nodiscard]] std::vector<TimeRecord> rattlesnake_records(
    const std::vector<NamedArray>& all);

/// Samples of a frame, where the records are frames of a modal test that stand
/// end to end, each with one hit; 0 where they are not.
[[nodiscard]] Eigen::Index rattlesnake_frame(
    const std::vector<NamedArray>& all);

}  // namespace tapfit::acquisition
