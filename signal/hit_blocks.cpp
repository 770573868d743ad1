#include "signal/hit_blocks.hpp"

#include "acquisition/input_error.hpp"
#include "signal/offset.hpp"
#include "signal/ringing.hpp"
#include "signal/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Tapers this long keep the ringing of an anti-alias filter, which sits at the
// end of the spectrum, from leaking down into the band.
constexpr Index taper = 16;

// One accepted hit within its recording.
struct Place {
  Index trigger = 0;
  Index pulse_samples = 0;
  Stretch before;  // quiet
  Stretch rings;   // where the earlier hit's ringing is fitted
  Stretch after;   // ringing, up to the next hit
};

std::vector<Place> places_of(const std::vector<acquisition::Hit>& hits,
                             Index n_samples,
                             double fs,
                             Index block,
                             Index wanted,
                             const Eigen::VectorXcd& ringing_poles) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k].accepted) continue;
    Place place;
    place.trigger = hits[k].trigger;
    place.pulse_samples = static_cast<Index>(std::ceil(hits[k].pulse_s * fs));
    const Index margin = taper + 4 * std::max<Index>(place.pulse_samples, 2);
    const Index earlier = k == 0 ? 0 : hits[k - 1].trigger + margin;
    const Index later =
        k + 1 < hits.size() ? hits[k + 1].trigger - margin : n_samples;
    // A short pre-trigger must not be lost to the margin altogether.
    const Index onset = place.trigger - std::min(margin, place.trigger / 2);
    place.before = quiet_stretch(earlier, onset, wanted);
    if (k > 0) {
      place.rings = ringing_stretch(
          ringing_poles, fs, quiet_stretch(earlier, onset, n_samples));
    }
    const Index start = std::min(place.trigger, n_samples);
    place.after = {start,
                   std::clamp(start + block, start, std::max(start, later))};
    places.push_back(place);
  }
  return places;
}

// Rows of a block around the trigger; zero where the file has no samples.
Eigen::VectorXd cut(const Eigen::Ref<const Eigen::VectorXd>& channel,
                    Index begin,
                    Index block) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(block);
  const Index first = std::max<Index>(begin, 0);
  const Index last = std::min(begin + block, channel.size());
  if (last > first)
    x.segment(first - begin, last - first) =
        channel.segment(first, last - first);
  return x;
}

// Cuts all hits of one channel and collects the noise before them.
struct CutChannel {
  Eigen::MatrixXd blocks;
  std::vector<Eigen::VectorXd> quiet;
};

// Length of the blocks, and of the quiet that gives the offset [samples].
struct Lengths {
  Index block = 0;
  Index pre_trigger = 0;
  Index wanted = 0;
};

CutChannel cut_channel(const Eigen::Ref<const Eigen::VectorXd>& recorded,
                       const std::vector<Place>& places,
                       const Lengths& lengths,
                       const Eigen::VectorXcd& ringing_poles,
                       double fs) {
  const Index block = lengths.block;
  CutChannel result;
  result.blocks.resize(block, static_cast<Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place& p = places[k];
    const Index begin = p.trigger - lengths.pre_trigger;
    Eigen::VectorXd channel = recorded;
    if (p.rings.length() > 0) {
      const Index from = std::max<Index>(0, std::min(p.before.begin, begin));
      const Index to = std::min(begin + block, recorded.size());
      channel.segment(from, to - from) -=
          ringing(recorded, p.rings, ringing_poles, fs, from, to - from);
    }
    const double level =
        offset_at_hit(channel, p.before, p.after, lengths.wanted);
    Eigen::VectorXd x = cut(channel, begin, block);
    for (Index i = 0; i < block; ++i)
      if (begin + i >= 0 && begin + i < channel.size()) x(i) -= level;
    result.blocks.col(static_cast<Index>(k)) = x;
    result.quiet.emplace_back(
        channel.segment(p.before.begin, p.before.length()).array() - level);
  }
  return result;
}

double rms(const Eigen::VectorXd& x) {
  return x.size() == 0 ? 0.0
                       : x.norm() / std::sqrt(static_cast<double>(x.size()));
}

// Windows of all hits, block x hits.
struct Windows {
  Eigen::MatrixXd force;
  Eigen::MatrixXd response;
  Index force_end = 0;  // rows of force from here on are zero
};

Windows windows_of(const CutChannel& force,
                   const std::vector<Place>& places,
                   Index pre_trigger,
                   bool force_window) {
  const Index block = force.blocks.rows();
  Windows windows{force.blocks, force.blocks, force_window ? 0 : block};
  for (Index k = 0; k < force.blocks.cols(); ++k) {
    const std::size_t hit = static_cast<std::size_t>(k);
    const PulseSpan span = find_pulse(force.blocks.col(k),
                                      pre_trigger,
                                      places[hit].pulse_samples,
                                      rms(force.quiet[hit]));
    windows.response.col(k) = causal_window(block, span, taper);
    windows.force.col(k) = force_window ? pulse_window(block, span, taper)
                                        : causal_window(block, span, taper);
    windows.force_end =
        std::max(windows.force_end, std::min(block, span.end + taper));
  }
  return windows;
}

void check_force(const Eigen::MatrixXd& force, const acquisition::Run& run) {
  for (Index k = 0; k < force.cols(); ++k)
    if (!(force.col(k).cwiseAbs().maxCoeff() > 0.0))
      throw InputError("the hammer's channel is zero throughout a hit",
                       run.file.string(),
                       "reject the hit or check the hammer's channel");
}

}  // namespace

HitBlocks cut_hits(const acquisition::Run& run,
                   const acquisition::Recording& recording,
                   const acquisition::HitSet& hits,
                   const std::vector<acquisition::Hit>& run_hits,
                   const BlockOptions& options) {
  const double fs = recording.sample_rate_hz;
  // Hann weights over four periods leave nothing of the band in the mean.
  const Index wanted = std::max<Index>(
      64, static_cast<Index>(std::ceil(4.0 * fs / options.lowest_hz)));
  const std::vector<Place> places = places_of(run_hits,
                                              recording.samples.rows(),
                                              fs,
                                              hits.block,
                                              wanted,
                                              options.ringing_poles);
  HitBlocks result;
  result.dt = 1.0 / fs;
  result.trigger = hits.pre_trigger;
  if (places.empty()) return result;
  const auto channel_at = [&](const acquisition::Placement& at,
                              const Eigen::VectorXcd& poles) {
    return cut_channel(recording.samples.col(static_cast<Index>(at.channel)),
                       places,
                       {hits.block, hits.pre_trigger, wanted},
                       poles,
                       fs);
  };

  CutChannel force = channel_at(run.hammer, {});
  const Windows windows =
      windows_of(force, places, hits.pre_trigger, options.force_window);
  result.force_noise = noise_spectrum(force.quiet, result.dt);
  result.force = force.blocks.cwiseProduct(windows.force);
  check_force(result.force, run);
  result.force_end = windows.force_end;
  result.force_power = windows.force.cwiseAbs2().rowwise().mean();
  result.response_power = windows.response.cwiseAbs2().rowwise().mean();
  for (const acquisition::Placement& sensor : run.sensors) {
    const CutChannel response = channel_at(sensor, options.ringing_poles);
    result.noise.push_back(noise_spectrum(response.quiet, result.dt));
    result.responses.emplace_back(
        response.blocks.cwiseProduct(windows.response));
  }
  return result;
}

}  // namespace tapfit::signal
