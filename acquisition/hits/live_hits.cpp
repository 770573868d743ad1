#include "acquisition/hits/live_hits.hpp"

#include "acquisition/hits/compare_hits.hpp"
#include "acquisition/hits/judge_saturation.hpp"

#include <algorithm>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Groups from the last hit given out on: its own pulses are passed over, and
// its trigger stands first, so that those after it know what rings.
std::vector<PulseGroup> groups_of(const HammerRun& work,
                                  const LivePiece& piece,
                                  const LiveSettings& settings,
                                  const LiveHits& known) {
  RunPulses pulses;
  pulses.samples = work.pulses.samples;
  const Index last = known.last_trigger - piece.start;
  for (const Pulse& pulse : work.pulses.pulses) {
    const bool over =
        known.last_trigger >= 0 && pulse.first < last + settings.set.hold_off;
    if (!over && pulse.first >= piece.own_begin) pulses.pulses.push_back(pulse);
  }
  return group_pulses(pulses, settings.set.hold_off);
}

Eigen::MatrixXd rows_of(const std::vector<Eigen::VectorXd>& levels) {
  Eigen::MatrixXd result(static_cast<Index>(levels.size()),
                         levels.empty() ? 0 : levels[0].size());
  for (Index i = 0; i < result.rows(); ++i) {
    result.row(i) = levels[static_cast<std::size_t>(i)].transpose();
  }
  return result;
}

// `hits` of the work's groups.
void judge_cut(const HammerRun& work,
               const LiveSettings& settings,
               std::vector<Hit>& hits) {
  if (!settings.ceiling) return;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!tells_height(hits[k])) continue;
    const PulseTop top = measure_top(
        work.hammer.force, work.groups[k].largest, work.hammer.noise);
    if (is_cut(*settings.ceiling, top)) reject(hits[k], HitFault::Overload);
  }
}

void compare(const Run& run,
             const LivePiece& piece,
             const HammerRun& work,
             const LiveSettings& settings,
             Hit& hit,
             LiveHits& known) {
  if (is_weak(hit.peak_n, known.peaks)) reject(hit, HitFault::Weak);
  if (!hit.accepted) return;
  known.levels.push_back(response_per_impulse(
      run, piece.recording, work.hammer, hit, settings.set));
  if (is_outlier(known.levels.back().transpose(),
                 rows_of(known.levels),
                 second_share(hit))) {
    reject(hit, HitFault::Outlier);
    known.levels.pop_back();
    return;
  }
  known.peaks.push_back(hit.peak_n);
  // The latest suffice, and memory stays bounded.
  constexpr std::size_t enough = 256;
  if (known.peaks.size() > enough) known.peaks.erase(known.peaks.begin());
  if (known.levels.size() > enough) known.levels.erase(known.levels.begin());
}

}  // namespace

void begin_run(LiveHits& known) {
  known.last_trigger = -1;
  known.peaks.clear();
}

FoundHits find_live_hits(const TestBundle& bundle,
                         const Run& run,
                         const LivePiece& piece,
                         const LiveSettings& settings,
                         LiveHits& known) {
  HammerRun work = prepare_run(run, piece.recording, settings.slope);
  work.level = settings.set.trigger_n;
  work.pulses.pulses = find_pulses(
      work.hammer.force, work.hammer.pieces, work.level, settings.rearm);
  work.groups = groups_of(work, piece, settings, known);
  FoundHits found;
  if (known.last_trigger >= 0) {
    Hit earlier;
    earlier.trigger = known.last_trigger - piece.start;
    earlier.accepted = false;
    found.hits.push_back(earlier);
    found.is_new.push_back(false);
  }
  const double start_s =
      static_cast<double>(piece.start) / piece.recording.sample_rate_hz;
  std::vector<Hit> judged = judge_alone(bundle,
                                        run,
                                        piece.recording,
                                        work,
                                        settings.set,
                                        settings.double_hit_percent);
  judge_cut(work, settings, judged);
  for (Hit& hit : judged) {
    const bool is_new = hit.trigger < piece.own_end;
    if (is_new) {
      compare(run, piece, work, settings, hit, known);
      known.last_trigger = piece.start + hit.trigger;
    }
    hit.accepted = hit.accepted && is_new;
    hit.time_s += start_s;
    found.hits.push_back(hit);
    found.is_new.push_back(is_new);
  }
  return found;
}

}  // namespace tapfit::acquisition
