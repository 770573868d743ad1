#include "tui/views/recording_state.hpp"

#include <algorithm>

namespace tapfit::tui {

using acquisition::Hit;

std::size_t hits_by(const RecordingInput& input,
                    std::size_t run,
                    double time_s) {
  const std::vector<Hit>& hits = input.hits.runs[run];
  const auto complete = [&](const Hit& hit) {
    const Eigen::Index end =
        std::min(hit.begin + input.hits.block, input.traces[run].samples);
    return static_cast<double>(end) <= time_s * input.hits.sample_rate_hz;
  };
  return static_cast<std::size_t>(
      std::count_if(hits.begin(), hits.end(), complete));
}

const acquisition::LeftOut* RecordingInput::not_used(std::size_t run) const {
  if (left_out == nullptr) return nullptr;
  const auto found =
      std::ranges::find(*left_out, run, &acquisition::LeftOut::run);
  return found == left_out->end() ? nullptr : &*found;
}

}  // namespace tapfit::tui
