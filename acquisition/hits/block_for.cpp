#include "acquisition/hits/block_for.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/samples/octave_decay.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// The largest hit of those with room enough to watch the response die.
const PulseGroup& clearest_hit(const std::vector<PulseGroup>& groups) {
  Index longest = 0;
  for (const PulseGroup& group : groups) {
    longest = std::max(longest, group.room);
  }
  const PulseGroup* best = nullptr;
  for (const PulseGroup& group : groups) {
    if (2 * group.room < longest) continue;
    if (best == nullptr || group.largest.height > best->largest.height) {
      best = &group;
    }
  }
  return *best;
}

/// How long a response lasts.
struct Lasting {
  Index samples = 0;  ///< until it is lost in its noise
  std::optional<OctaveDecay> slowest;
};

void join(const Lasting& other, Lasting& all) {
  all.samples = std::max(all.samples, other.samples);
  if (!other.slowest) return;
  if (!all.slowest || other.slowest->rate < all.slowest->rate) {
    all.slowest = other.slowest;
  }
}

Lasting longest(const std::vector<Lasting>& of) {
  Lasting all;
  for (const Lasting& one : of) join(one, all);
  return all;
}

// How long the responses of a run's clearest hit last.
Lasting lasting_response(const Run& run,
                         const Recording& recording,
                         const PulseGroup& hit,
                         const std::array<double, 2>& band_hz) {
  std::vector<Lasting> lasting(run.sensors.size());
  for_each_parallel(lasting.size(), [&](std::size_t k) {
    const auto channel =
        recording.samples.col(static_cast<Index>(run.sensors[k].channel));
    constexpr Index enough = 1 << 11;
    const double level = median(thinned(channel, enough));
    const Eigen::VectorXd response =
        channel.segment(hit.first.first, hit.room).array() - level;
    lasting[k] = {response_length(response),
                  slowest_decay(response, recording.sample_rate_hz, band_hz)};
  });
  return longest(lasting);
}

// The longest of all runs.
Lasting lasting_response(const std::vector<Run>& runs,
                         const std::vector<Recording>& recordings,
                         const std::vector<HammerRun>& work,
                         const std::array<double, 2>& band_hz) {
  std::vector<Lasting> lasting(work.size());
  for_each_parallel(work.size(), [&](std::size_t r) {
    lasting[r] = lasting_response(
        runs[r], recordings[r], clearest_hit(work[r].groups), band_hz);
  });
  return longest(lasting);
}

}  // namespace

Block block_for(const TestBundle& bundle,
                const std::vector<Recording>& recordings,
                const std::vector<HammerRun>& work,
                const HitOptions& options) {
  const double rate = recordings[0].sample_rate_hz;
  const double low = bundle.band_hz ? (*bundle.band_hz)[0] : 0.0;
  const double high = band_end(bundle, rate);
  // 200 lines in the band and four periods of its lowest frequency.
  double least_s = 200.0 / (high - low);
  if (low > 0.0) least_s = std::max(least_s, 4.0 / low);
  BlockNeeds needs;
  const Lasting lasting =
      lasting_response(bundle.runs, recordings, work, {low, high});
  needs.lasting = lasting.samples;
  needs.slowest = lasting.slowest;
  needs.least = static_cast<Index>(std::ceil(least_s * rate));
  needs.pulse_width = usual_width(work);
  needs.sample_rate_hz = rate;
  std::vector<std::vector<PulseGroup>> groups;
  for (const HammerRun& run : work) groups.push_back(run.groups);
  Block block = choose_block(groups, needs, options);
  block.decay = {needs.slowest ? needs.slowest->rate : 0.0, needs.lasting};
  return block;
}

}  // namespace tapfit::acquisition
