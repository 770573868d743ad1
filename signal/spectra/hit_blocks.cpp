#include "signal/spectra/hit_blocks.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/judge_hits.hpp"
#include "signal/spectra/carry_over.hpp"
#include "signal/spectra/offset.hpp"
#include "signal/spectra/window.hpp"

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
  Index blows_before = 0;
  Index blows_after = 0;
  Stretch before;      // quiet
  Stretch rings;       // where the earlier hit's ringing is fitted
  Stretch after;       // ringing, up to the next hit
  bool whole = false;  // the block holds all of its samples and no other hit
};

// Length of the blocks, and of the quiet that gives the offset [samples].
struct Lengths {
  Index block = 0;
  Index pre_trigger = 0;
  Index wanted = 0;
};

std::vector<Place> places_of(const std::vector<acquisition::Hit>& hits,
                             Index n_samples,
                             double fs,
                             const Lengths& lengths,
                             const Eigen::VectorXcd& lasting_poles) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k].accepted) continue;
    Place place;
    place.trigger = hits[k].trigger;
    place.pulse_samples = static_cast<Index>(std::ceil(hits[k].pulse_s * fs));
    place.blows_before = hits[k].blows_before;
    place.blows_after = hits[k].blows_after;
    const Index margin = taper + 4 * std::max<Index>(place.pulse_samples, 2);
    const Index earlier =
        k == 0 ? 0
               : hits[k - 1].trigger +
                     std::max(margin, taper + hits[k - 1].blows_after);
    const Index later =
        k + 1 < hits.size() ? hits[k + 1].trigger - margin : n_samples;
    // A short pre-trigger must not be lost to the margin altogether.
    const Index onset = place.trigger - std::min(margin, place.trigger / 2);
    place.before = quiet_stretch(earlier, onset, lengths.wanted);
    if (k > 0) {
      place.rings = carry_over_stretch(
          lasting_poles, fs, quiet_stretch(earlier, onset, n_samples));
    }
    const Index start = std::min(place.trigger, n_samples);
    place.after = {
        start,
        std::clamp(start + lengths.block, start, std::max(start, later))};
    // The next pulse begins at most its width before its trigger.
    const Index next = k + 1 < hits.size()
                           ? hits[k + 1].trigger - place.pulse_samples
                           : n_samples;
    place.whole = place.trigger - lengths.pre_trigger + lengths.block <= next;
    places.push_back(place);
  }
  return places;
}

// Rows of a block around the trigger with the offset taken off; zero where the
// file has no samples.
void cut(const Eigen::Ref<const Eigen::VectorXd>& channel,
         Index begin,
         double level,
         Eigen::Ref<Eigen::VectorXd> x) {
  const Index first = std::max<Index>(begin, 0);
  const Index last = std::min(begin + x.size(), channel.size());
  if (last - first < x.size()) x.setZero();
  if (last <= first) return;
  x.segment(first - begin, last - first) =
      channel.segment(first, last - first).array() - level;
}

// Cuts all hits of one channel and collects the noise before them.
struct CutChannel {
  Eigen::MatrixXd blocks;
  std::vector<Eigen::VectorXd> quiet;
};

CutChannel cut_channel(const Eigen::Ref<const Eigen::VectorXd>& recorded,
                       const std::vector<Place>& places,
                       const Lengths& lengths,
                       const Eigen::VectorXcd& lasting_poles,
                       double fs) {
  const Index block = lengths.block;
  CutChannel result;
  result.blocks.resize(block, static_cast<Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place& p = places[k];
    const Index begin = p.trigger - lengths.pre_trigger;
    // The record itself, unless ringing has to be taken off a copy.
    Eigen::VectorXd rung;
    if (p.rings.length() > 0) {
      rung = recorded;
      const Index from = std::max<Index>(0, std::min(p.before.begin, begin));
      const Index to = std::min(begin + block, recorded.size());
      rung.segment(from, to - from) -=
          carry_over(recorded, p.rings, lasting_poles, fs, from, to - from);
    }
    const Eigen::Map<const Eigen::VectorXd> channel(
        rung.size() > 0 ? rung.data() : recorded.data(), recorded.size());
    const double level =
        offset_at_hit(channel, p.before, p.after, lengths.wanted);
    cut(channel, begin, level, result.blocks.col(static_cast<Index>(k)));
    result.quiet.emplace_back(
        channel.segment(p.before.begin, p.before.length()).array() - level);
  }
  return result;
}

// What follows behind the blocks, as far as their ends are this hit's.
BlockTail tail_of(const CutChannel& response,
                  const std::vector<Place>& places,
                  const HitBlocks& cut,
                  const Eigen::VectorXcd& poles) {
  BlockTail tail = fit_tail(response.blocks, cut.trigger, cut.dt, poles);
  for (std::size_t k = 0; tail.poles.size() > 0 && k < places.size(); ++k) {
    if (!places[k].whole) tail.amplitudes.col(static_cast<Index>(k)).setZero();
  }
  return tail;
}

double rms(const Eigen::VectorXd& x) {
  return x.size() == 0 ? 0.0
                       : x.norm() / std::sqrt(static_cast<double>(x.size()));
}

// Where each hit's pulse lies in its block.
std::vector<PulseSpan> pulse_spans(const CutChannel& force,
                                   const std::vector<Place>& places,
                                   Index pre_trigger) {
  std::vector<PulseSpan> spans;
  for (std::size_t k = 0; k < places.size(); ++k) {
    PulseSpan span = find_pulse(force.blocks.col(static_cast<Index>(k)),
                                pre_trigger,
                                places[k].pulse_samples,
                                rms(force.quiet[k]));
    span.begin =
        std::clamp<Index>(pre_trigger - places[k].blows_before, 0, span.begin);
    span.end = std::clamp<Index>(
        pre_trigger + places[k].blows_after, span.end, force.blocks.rows());
    spans.push_back(span);
  }
  return spans;
}

void apply(bool only_pulse,
           const PulseSpan& span,
           Eigen::Ref<Eigen::VectorXd> block) {
  if (only_pulse) {
    apply_pulse_window(span, taper, block);
  } else {
    apply_causal_window(span, taper, block);
  }
}

// Applies each hit's window to its column.
void apply(bool only_pulse,
           const std::vector<PulseSpan>& spans,
           Eigen::MatrixXd& blocks) {
  for (Index k = 0; k < blocks.cols(); ++k) {
    apply(only_pulse, spans[static_cast<std::size_t>(k)], blocks.col(k));
  }
}

// Mean over hits of the squared window, per row.
Eigen::VectorXd window_power(Index block,
                             bool only_pulse,
                             const std::vector<PulseSpan>& spans) {
  Eigen::VectorXd window(block);
  Eigen::VectorXd power = Eigen::VectorXd::Zero(block);
  for (const PulseSpan& span : spans) {
    // Behind the pulse it is nothing, or as it was before.
    const Index end = std::min(block, span.end + taper);
    window.head(end).setOnes();
    apply(only_pulse, span, window.head(end));
    power.head(end) += window.head(end).cwiseAbs2();
    if (!only_pulse) power.tail(block - end).array() += 1.0;
  }
  return power / static_cast<double>(spans.size());
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
  const Lengths lengths{hits.block, hits.pre_trigger, wanted};
  const std::vector<Place> places = places_of(
      run_hits, recording.samples.rows(), fs, lengths, options.lasting_poles);
  HitBlocks result;
  result.dt = 1.0 / fs;
  result.trigger = hits.pre_trigger;
  if (places.empty()) return result;
  const auto channel_at = [&](const acquisition::Placement& at,
                              const Eigen::VectorXcd& poles) {
    return cut_channel(recording.samples.col(static_cast<Index>(at.channel)),
                       places,
                       lengths,
                       poles,
                       fs);
  };

  // Stretches are the same in all channels.
  CutChannel force = channel_at(run.hammer, {});
  result.force_noise = noise_spectrum(force.quiet, result.dt);
  result.quiet = result.force_noise.S.size() > 0;
  const std::vector<PulseSpan> spans =
      pulse_spans(force, places, hits.pre_trigger);
  apply(options.force_window, spans, force.blocks);
  result.force = std::move(force.blocks);
  check_force(result.force, run);
  result.force_end = hits.block;
  if (options.force_window) {
    result.force_end = 0;
    for (const PulseSpan& span : spans) {
      result.force_end =
          std::max(result.force_end, std::min(hits.block, span.end + taper));
    }
  }
  result.force_power = window_power(hits.block, options.force_window, spans);
  result.response_power = window_power(hits.block, false, spans);
  result.noise.resize(run.sensors.size());
  result.responses.resize(run.sensors.size());
  result.tails.resize(run.sensors.size());
  for_each_parallel(run.sensors.size(), [&](std::size_t c) {
    CutChannel response = channel_at(run.sensors[c], options.lasting_poles);
    result.noise[c] = noise_spectrum(response.quiet, result.dt);
    if (!result.quiet) {
      const double most = acquisition::difference_noise(
          recording.samples.col(static_cast<Index>(run.sensors[c].channel)));
      result.noise[c].S = Eigen::VectorXd::Constant(1, most * most);
    }
    result.tails[c] = tail_of(response, places, result, options.lasting_poles);
    apply(false, spans, response.blocks);
    result.responses[c] = std::move(response.blocks);
  });
  return result;
}

}  // namespace tapfit::signal
