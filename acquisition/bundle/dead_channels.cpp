#include "acquisition/bundle/dead_channels.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::acquisition {

DeadChannels::DeadChannels(const TestBundle& bundle, const Run& run)
    : bundle_(bundle), run_(run) {
  unchanged_.push_back({run.hammer.channel});
  for (const Placement& sensor : run.sensors) {
    unchanged_.push_back({sensor.channel});
  }
}

void DeadChannels::look_at(const Eigen::Ref<const Eigen::MatrixXd>& samples) {
  if (samples.rows() == 0) return;
  const auto column = [&](const Unchanged& one) {
    return samples.col(static_cast<Eigen::Index>(one.channel));
  };
  if (count_ == 0) {
    for (Unchanged& one : unchanged_) one.value = column(one)[0];
  }
  count_ += samples.rows();
  // Mostly the second sample already differs.
  std::erase_if(unchanged_, [&](const Unchanged& one) {
    const auto values = column(one);
    return std::any_of(values.begin(), values.end(), [&](double value) {
      return value != one.value;
    });
  });
}

void DeadChannels::refuse() const {
  if (count_ == 0 || unchanged_.empty()) return;
  if (count_ == 1) {
    throw InputError("the recording is one sample long",
                     run_.file.string(),
                     "record the run again, or take it out of `runs`");
  }
  const Unchanged& dead = unchanged_.front();
  const Channel& channel = bundle_.channels[dead.channel];
  throw InputError(
      fmt::format("channel \"{}\" is dead: every sample is {:g} {}",
                  channel.name,
                  dead.value / channel.unit_to_si,
                  channel.unit),
      run_.file.string(),
      "record the run again, or take the channel (or the run) "
      "out of `runs`");
}

}  // namespace tapfit::acquisition
