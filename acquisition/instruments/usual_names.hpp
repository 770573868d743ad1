// What programs and people call the things that stand beside samples.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// What an array or attribute is by its name.
enum class UsualName {
  None,
  Rate,  ///< fs, sample_rate, SampleRate, samplingFrequency, ...
  Step,  ///< dt, increment, wf_increment, sampling_interval, ...
  Time,  ///< t, time, time_s, abscissa, ...
  Names,
  Units,
};

/// The last part of a name: "fs" of "run.fs", "run/fs", "acc@fs".
[[nodiscard]] std::string_view last_part(std::string_view name);

/// Blanks, dashes, underscores, upper and lower case do not matter.
[[nodiscard]] UsualName usual_name(std::string_view name);

}  // namespace tapfit::acquisition
