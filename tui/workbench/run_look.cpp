#include "tui/workbench/run_look.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "signal/estimate/frf_average.hpp"
#include "signal/spectra/fft.hpp"
#include "signal/spectra/spectra.hpp"

#include <cmath>

namespace tapfit::tui {
namespace {

using acquisition::Hit;
using Eigen::Index;
using signal::HitBlocks;

/// Only that hit counts.
std::vector<Hit> alone(std::vector<Hit> hits, std::size_t wanted) {
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i].accepted = i == wanted;
  return hits;
}

HitWindow window_of(const HitBlocks& blocks, const Hit& hit, double sigma) {
  HitWindow window;
  const auto seconds = [&](Index samples) {
    return blocks.dt * static_cast<double>(samples);
  };
  const Index begin = hit.trigger - blocks.trigger;
  window.begin_s = seconds(begin);
  window.trigger_s = seconds(hit.trigger);
  window.end_s = seconds(begin + blocks.force.rows());
  window.sigma = sigma;
  window.step_s = blocks.dt;
  const Eigen::VectorXd force = blocks.force_power.cwiseSqrt();
  Index first = 0;
  while (first < force.size() && force[first] == 0.0) ++first;
  Index last = force.size();
  while (last > first && force[last - 1] == 0.0) --last;
  window.pulse_s = seconds(begin + first);
  window.pulse = force.segment(first, last - first);
  return window;
}

}  // namespace

double HitWindow::exponential(double time_s) const {
  if (time_s < begin_s || time_s > end_s) return 0.0;
  return std::exp(-sigma * (time_s - trigger_s));
}

RunLook look_at_run(const acquisition::TestBundle& bundle,
                    const std::vector<acquisition::Recording>& recordings,
                    const acquisition::HitSet& hits,
                    std::size_t run) {
  RunLook look;
  const signal::FrfPlan plan = signal::plan_frfs(bundle, hits, {});
  look.s = plan.s;
  const std::vector<acquisition::RunGroup> groups =
      acquisition::runs_alike(bundle);
  const acquisition::RunGroup& group =
      groups[acquisition::group_of(groups, run)];
  look.coherence = part_of(
      signal::group_coherence(bundle, recordings, hits, group), bundle, run);
  const signal::RealFft fft(hits.block);
  signal::RunAverage average;
  average.s = plan.s;
  const auto add = [&](const HitBlocks& blocks) {
    signal::add_hits(
        blocks,
        signal::fft_spectra(blocks, fft, plan.sigma, plan.first, plan.last),
        average);
  };
  for (const std::size_t earlier : group) {
    if (earlier == run) break;
    const HitBlocks blocks =
        signal::cut_hits(arranged_as(bundle.runs.at(run), bundle.runs[earlier]),
                         recordings.at(earlier),
                         hits,
                         hits.runs.at(earlier),
                         plan.blocks);
    if (blocks.force.cols() > 0) add(blocks);
  }
  const std::vector<Hit>& run_hits = hits.runs.at(run);
  for (std::size_t k = 0; k < run_hits.size(); ++k) {
    look.windows.emplace_back();
    HitBlocks blocks;
    try {
      blocks = signal::cut_hits(bundle.runs.at(run),
                                recordings.at(run),
                                hits,
                                alone(run_hits, k),
                                plan.blocks);
    } catch (const InputError&) {
      continue;  // no force in it: nothing to window
    }
    look.windows.back() = window_of(blocks, run_hits[k], plan.sigma);
    if (!run_hits[k].accepted) continue;
    add(blocks);
    look.averages.push_back(
        signal::average_frfs(average, bundle, run, signal::Estimator::H1));
  }
  return look;
}

}  // namespace tapfit::tui
