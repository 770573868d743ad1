#include "acquisition/checks/channel_record.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/judge_hits.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Samples = Eigen::Ref<const VectorXd>;

constexpr Index fewest_equal = 9;
constexpr Index beside = 32;  // samples looked at on either side
constexpr double moving_quanta = 4.0;
constexpr Index samples_for_zero = 4096;

// Changes below this share of the peak are rounding of the scaling to SI.
constexpr double rounding = 1e-10;

double least_change(const Samples& x, double peak) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 1; i < x.size(); ++i) {
    const double change = std::abs(x(i) - x(i - 1));
    if (change > rounding * peak) least = std::min(least, change);
  }
  return std::isfinite(least) ? least : 0.0;
}

// Rms change from sample to sample beside the stretch first ... last.
double change_beside(const Samples& x, Index first, Index last) {
  double sum = 0.0;
  Index count = 0;
  for (Index i = std::max<Index>(first - beside, 1);
       i < std::min(last + beside, x.size());
       ++i) {
    if (i >= first && i <= last + 1) continue;
    sum += std::pow(x(i) - x(i - 1), 2);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

void find_dropouts(const Samples& x, double rate, ChannelRecord& record) {
  const double high = x.maxCoeff();
  const double low = x.minCoeff();
  for (Index i = 0; i + 1 < x.size();) {
    Index last = i;
    while (last + 1 < x.size() && x(last + 1) == x(i)) ++last;
    const bool clipped = x(i) == high || x(i) == low;
    if (last - i + 1 >= fewest_equal && !clipped &&
        change_beside(x, i, last) > moving_quanta * record.step) {
      if (record.dropouts == 0) {
        record.first_dropout_s = static_cast<double>(i) / rate;
      }
      ++record.dropouts;
    }
    i = last + 1;
  }
}

// Level over the blocks and how their means change.
void look_at_blocks(const Samples& x,
                    double baseline,
                    const std::vector<Hit>& hits,
                    Index block,
                    ChannelRecord& record) {
  double power = 0.0;
  Index samples = 0;
  double change = 0.0;
  int changes = 0;
  double before = 0.0;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const Index begin = std::clamp<Index>(hits[k].begin, 0, x.size());
    const Index count = std::min(block, x.size() - begin);
    if (count < block / 2 || count == 0) continue;
    const auto part = x.segment(begin, count);
    const double mean = part.mean();
    if (samples > 0) {
      change += std::pow(mean - before, 2);
      ++changes;
    }
    before = mean;
    power += (part.array() - baseline).square().sum();
    samples += count;
  }
  if (samples > 0) {
    record.level = std::sqrt(power / static_cast<double>(samples));
  }
  if (changes > 0) record.drift = std::sqrt(change / changes);
}

ChannelRecord record_of(const TestBundle& bundle,
                        std::size_t run,
                        std::size_t channel,
                        const Recording& recording,
                        const std::vector<Hit>& hits,
                        Index block) {
  const Samples x = recording.samples.col(static_cast<Index>(channel));
  ChannelRecord record;
  record.run = run;
  record.channel = channel;
  record.full_scale = std::abs(bundle.channels[channel].full_scale_si());
  const double baseline = median(thinned(x, samples_for_zero));
  record.peak = (x.array() - baseline).abs().maxCoeff();
  record.noise = difference_noise(x);
  record.step = least_change(x, record.peak);
  find_dropouts(x, recording.sample_rate_hz, record);
  look_at_blocks(x, baseline, hits, block, record);
  return record;
}

}  // namespace

double ChannelRecord::bits() const {
  return step > 0.0 && peak > 0.0 ? std::log2(2.0 * peak / step) : 0.0;
}

std::vector<ChannelRecord> channel_records(const TestBundle& bundle,
                                           std::size_t run,
                                           const Recording& recording,
                                           const std::vector<Hit>& hits,
                                           Index block) {
  if (recording.samples.rows() == 0) return {};
  std::vector<std::size_t> channels{bundle.runs[run].hammer.channel};
  for (const Placement& sensor : bundle.runs[run].sensors) {
    channels.push_back(sensor.channel);
  }
  std::vector<ChannelRecord> records;
  for (const std::size_t channel : channels) {
    records.push_back(record_of(bundle, run, channel, recording, hits, block));
  }
  return records;
}

std::vector<ChannelRecord> channel_records(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits) {
  std::vector<std::vector<ChannelRecord>> of(recordings.size());
  for_each_parallel(recordings.size(), [&](std::size_t r) {
    const bool found = r < hits.runs.size();
    of[r] = channel_records(bundle,
                            r,
                            recordings[r],
                            found ? hits.runs[r] : std::vector<Hit>{},
                            hits.block);
  });
  std::vector<ChannelRecord> all;
  for (const auto& records : of) {
    all.insert(all.end(), records.begin(), records.end());
  }
  return all;
}

}  // namespace tapfit::acquisition
