#include "signal/estimate/estimate_frfs.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/checks/rejected_hits.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "signal/decay/block_advice.hpp"
#include "signal/estimate/frf_average.hpp"
#include "signal/estimate/linearity_check.hpp"
#include "signal/estimate/run_consistency.hpp"
#include "signal/spectra/spectra.hpp"
#include "signal/spectra/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <thread>
#include <tuple>

namespace tapfit::signal {
namespace {

using acquisition::HitSet;
using acquisition::Recording;
using acquisition::Run;
using acquisition::RunGroup;
using acquisition::TestBundle;
using Eigen::Index;

// What is done with every run, and where its lines lie.
struct Plan {
  Eigen::VectorXcd s;
  BlockOptions blocks;
  Estimator estimator = Estimator::H1;
  std::function<Spectra(const HitBlocks&)> transform;
  /// Where it is to be seen whether responses die within the block; empty:
  /// nowhere.
  std::optional<std::array<double, 2>> lasting_hz;
  double sigma = 0.0;
};

// Mean coherence below which a sensor hears little of the hits: more than half
// of its power comes from elsewhere.
constexpr double mostly_noise = 0.5;
constexpr std::uint64_t level_seed = 1;

void state_noise(const Frf& frf, std::vector<std::string>& statements) {
  if (frf.coherence.mean() >= mostly_noise) return;
  statements.push_back(
      fmt::format("{} (run {}): mean coherence {:.2f}, the sensor hears little "
                  "of the hits; look at its cable and range",
                  name(frf),
                  frf.run + 1,
                  frf.coherence.mean()));
}

std::string no_quiet(std::size_t run) {
  return fmt::format(
      "run {}: a single hit with no quiet before it; how far its FRFs scatter "
      "is not known, and counted as what neighbouring samples differ by at the "
      "least, which may be too much. Hit again, or begin to record a second "
      "before the blow",
      run + 1);
}

/// What is kept of one run until those of its like are there.
struct RunPart {
  Spectra spectra;  ///< no columns where none of its hits is accepted
  RunAverage average;
  DecayCheck lasting;
  bool heard = false;  ///< whether a hit is accepted
  bool quiet = true;   ///< whether something precedes its hits
};

RunPart part_of(const HitBlocks& blocks, const Plan& plan) {
  RunPart part;
  if (blocks.force.cols() == 0) return part;
  part.heard = true;
  part.quiet = blocks.quiet;
  part.spectra = plan.transform(blocks);
  if (plan.lasting_hz) part.lasting = check_decay(blocks, *plan.lasting_hz);
  part.average.s = plan.s;
  add_hits(blocks, part.spectra, part.average);
  return part;
}

/// What comes of the runs of one placement; no FRFs where none of their hits is
/// accepted.
struct GroupResult {
  std::vector<Frf> frfs;
  LinearityCheck levels;
  bool scatter_known = true;
  std::optional<Finding> difference;  ///< between the runs
};

// Takes the runs' spectra, which are large.
GroupResult estimate_group(const TestBundle& bundle,
                           const RunGroup& group,
                           std::vector<RunPart>& parts,
                           const Plan& plan) {
  GroupResult result;
  RunAverage average;
  average.s = plan.s;
  std::vector<Spectra> spectra;
  std::vector<RunPowers> runs;
  bool quiet = true;
  for (std::size_t k = 0; k < group.size(); ++k) {
    RunPart& part = parts[group[k]];
    if (!part.heard) continue;
    add_hits(part.average, average);
    runs.push_back({k, std::move(part.average.powers)});
    spectra.push_back(std::move(part.spectra));
    part.spectra = {};
    quiet = quiet && part.quiet;
  }
  if (average.hits() == 0) return result;
  result.scatter_known = quiet || average.hits() > 1;
  const Spectra all = side_by_side(std::move(spectra));
  if (const auto difference = run_inconsistency(runs)) {
    result.difference = finding_of(*difference, bundle, group);
  }
  const Eigen::MatrixXcd change = result.levels.add(all);
  result.frfs = average_frfs(average, bundle, group.front(), plan.estimator);
  for (Frf& frf : result.frfs) frf.run = group[runs.front().place];
  for (Index c = 0; c < change.cols(); ++c) {
    result.frfs[static_cast<std::size_t>(c)].change_with_level = change.col(c);
  }
  return result;
}

std::vector<Index> lengths_of(const std::vector<Recording>& recordings) {
  std::vector<Index> samples;
  for (const Recording& recording : recordings) {
    samples.push_back(recording.samples.rows());
  }
  return samples;
}

// Joins the groups in their order.
FrfSet joined(const TestBundle& bundle,
              const std::vector<RunPart>& parts,
              const std::vector<RunGroup>& groups,
              std::vector<GroupResult>& results,
              const Plan& plan) {
  FrfSet set;
  set.s = plan.s;
  LinearityCheck levels;
  for (std::size_t r = 0; r < parts.size(); ++r) {
    if (!parts[r].heard) {
      set.statements.push_back(
          fmt::format("run {} ({}) is left out: none of its hits is accepted",
                      r + 1,
                      bundle.runs[r].file.filename().string()));
    }
    const std::size_t g = acquisition::group_of(groups, r);
    if (groups[g].front() != r) continue;
    GroupResult& result = results[g];
    if (!result.scatter_known) set.statements.push_back(no_quiet(r));
    if (result.difference) {
      set.statements.push_back(in_full(*result.difference));
      set.findings.push_back(std::move(*result.difference));
    }
    for (Frf& frf : result.frfs) {
      state_noise(frf, set.statements);
      set.frfs.push_back(std::move(frf));
    }
    levels.add(std::move(result.levels));
  }
  set.level = levels.finding(level_seed);
  const std::string dependence = statement(set.level);
  if (!dependence.empty()) set.statements.push_back(dependence);
  return set;
}

// Seconds from trigger to the block's end.
double ringing_time(const HitSet& hits) {
  return static_cast<double>(hits.block - hits.pre_trigger) /
         hits.sample_rate_hz;
}

FrfSet estimate_all(const TestBundle& bundle,
                    const std::vector<Recording>& recordings,
                    const HitSet& hits,
                    const Plan& plan,
                    const Progress& progress) {
  const std::vector<RunGroup> groups = acquisition::runs_alike(bundle);
  std::vector<RunPart> parts(bundle.runs.size());
  std::vector<GroupResult> results(groups.size());
  std::vector<std::atomic<std::size_t>> ready(groups.size());
  std::atomic<std::size_t> done = 0;
  // Whoever asked is told from his own thread only.
  const auto asked = std::this_thread::get_id();
  for_each_parallel(parts.size(), [&](std::size_t r) {
    if (std::this_thread::get_id() == asked) {
      progress("FRFs",
               static_cast<double>(done) / static_cast<double>(parts.size()));
    }
    const std::size_t g = acquisition::group_of(groups, r);
    const Run run = arranged_as(bundle.runs[groups[g].front()], bundle.runs[r]);
    parts[r] = part_of(
        cut_hits(run, recordings[r], hits, hits.runs[r], plan.blocks), plan);
    // Whoever is last: spectra are kept no longer than needed.
    if (++ready[g] == groups[g].size()) {
      results[g] = estimate_group(bundle, groups[g], parts, plan);
    }
    ++done;
  });
  progress("FRFs", 1.0);
  FrfSet set = joined(bundle, parts, groups, results, plan);
  if (set.frfs.empty()) {
    throw acquisition::no_accepted_hit(bundle, recordings, hits);
  }
  const std::string followed =
      tail_statement(plan.blocks.lasting_poles, ringing_time(hits));
  if (!followed.empty()) set.statements.push_back(followed);
  if (!plan.lasting_hz) return set;
  DecayCheck lasting;
  for (const RunPart& part : parts) lasting.join(part.lasting);
  const std::vector<std::string> said = lasting_statements(
      lasting, hits, lengths_of(recordings), *plan.lasting_hz, plan.sigma);
  set.statements.insert(set.statements.begin(), said.begin(), said.end());
  return set;
}

void check_blocks(const TestBundle& bundle, const HitSet& hits) {
  if (hits.block >= 2 && hits.pre_trigger >= 0 &&
      hits.pre_trigger < hits.block && hits.sample_rate_hz > 0.0)
    return;
  throw InputError(
      fmt::format("a block of {} samples, {} of them before the trigger, "
                  "holds no response",
                  hits.block,
                  hits.pre_trigger),
      bundle.folder.string(),
      "give a longer block or a shorter pre-trigger");
}

void check(const TestBundle& bundle,
           const std::vector<Recording>& recordings,
           const HitSet& hits) {
  if (recordings.size() != bundle.runs.size() ||
      hits.runs.size() != bundle.runs.size())
    throw InputError(fmt::format("{} runs, but {} recordings and hits of {}",
                                 bundle.runs.size(),
                                 recordings.size(),
                                 hits.runs.size()),
                     bundle.folder.string(),
                     "read the recordings anew");
  check_blocks(bundle, hits);
}

// Lowest frequency of interest: no lower than the block resolves.
double lowest_hz(const Eigen::VectorXcd& s, const HitSet& hits) {
  return std::max(s.imag().cwiseAbs().minCoeff() / (2.0 * std::numbers::pi),
                  1.0 / ringing_time(hits));
}

std::array<double, 2> band_of(const Eigen::VectorXcd& s) {
  return {s(0).imag() / (2.0 * std::numbers::pi),
          s(s.size() - 1).imag() / (2.0 * std::numbers::pi)};
}

// FFT lines inside the band; line 0 is left out, an accelerance holds
// nothing there but the sensors' offset.
std::pair<Index, Index> lines_in_band(const TestBundle& bundle,
                                      const HitSet& hits) {
  const double step = hits.sample_rate_hz / static_cast<double>(hits.block);
  Index first = 1;
  Index last = hits.block / 2;
  if (bundle.band_hz) {
    first = std::max(
        first,
        static_cast<Index>(std::ceil((*bundle.band_hz)[0] / step - 1e-9)));
    last = std::min(
        last,
        static_cast<Index>(std::floor((*bundle.band_hz)[1] / step + 1e-9)));
  }
  if (last < first)
    throw InputError(
        fmt::format("no line lies in the band (lines are {:.4g} Hz apart, up "
                    "to {:.4g} Hz)",
                    step,
                    0.5 * hits.sample_rate_hz),
        "test.json: band_hz",
        "widen the band or lengthen the block");
  return {first, last};
}

}  // namespace

FrfPlan plan_frfs(const TestBundle& bundle,
                  const HitSet& hits,
                  const FrfOptions& options) {
  check_blocks(bundle, hits);
  FrfPlan plan;
  std::tie(plan.first, plan.last) = lines_in_band(bundle, hits);
  const double step_hz = hits.sample_rate_hz / static_cast<double>(hits.block);
  plan.sigma = decay_rate(options.window.end_value, ringing_time(hits));
  plan.s.resize(plan.last - plan.first + 1);
  for (Index i = 0; i < plan.s.size(); ++i)
    plan.s(i) = {
        plan.sigma,
        2.0 * std::numbers::pi * step_hz * static_cast<double>(plan.first + i)};
  plan.blocks = {options.window.force_window,
                 lowest_hz(plan.s, hits),
                 options.lasting_poles};
  return plan;
}

std::vector<std::string> block_statements(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits,
    const FrfOptions& options) {
  check(bundle, recordings, hits);
  const std::array<double, 2> band_hz =
      bundle.band_hz.value_or(std::array{0.0, 0.5 * hits.sample_rate_hz});
  const BlockOptions blocks{options.window.force_window,
                            std::max(band_hz[0], 1.0 / ringing_time(hits)),
                            options.lasting_poles};
  std::vector<DecayCheck> lasting(bundle.runs.size());
  for_each_parallel(lasting.size(), [&](std::size_t r) {
    lasting[r] = check_decay(
        cut_hits(bundle.runs[r], recordings[r], hits, hits.runs[r], blocks),
        band_hz);
  });
  DecayCheck all;
  for (const DecayCheck& of : lasting) all.join(of);
  return lasting_statements(
      all,
      hits,
      lengths_of(recordings),
      band_hz,
      decay_rate(options.window.end_value, ringing_time(hits)));
}

FrfSet estimate_frfs(const TestBundle& bundle,
                     const std::vector<Recording>& recordings,
                     const HitSet& hits,
                     const FrfOptions& options,
                     const Progress& progress) {
  check(bundle, recordings, hits);
  const FrfPlan fft = plan_frfs(bundle, hits, options);
  Plan plan;
  plan.s = fft.s;
  plan.lasting_hz = band_of(fft.s);
  plan.sigma = fft.sigma;
  plan.blocks = fft.blocks;
  plan.estimator = options.estimator;
  const RealFft transform(hits.block);
  plan.transform = [&fft, &transform](const HitBlocks& b) {
    return fft_spectra(b, transform, fft.sigma, fft.first, fft.last);
  };
  return estimate_all(bundle, recordings, hits, plan, progress);
}

FrfSet estimate_frfs_at(const TestBundle& bundle,
                        const std::vector<Recording>& recordings,
                        const HitSet& hits,
                        const Eigen::VectorXcd& s,
                        const Eigen::VectorXcd& lasting_poles,
                        const Progress& progress) {
  check(bundle, recordings, hits);
  if (s.size() == 0 || !s.allFinite() || s.real().minCoeff() < 0.0)
    throw InputError("FRFs are asked for at no line, or at Re(s) < 0",
                     "estimate_frfs_at",
                     "give lines on or to the right of the imaginary axis");
  Plan plan;
  plan.s = s;
  plan.blocks = {true, lowest_hz(s, hits), lasting_poles};
  plan.transform = [&s](const HitBlocks& b) { return spectra_at(b, s); };
  return estimate_all(bundle, recordings, hits, plan, progress);
}

}  // namespace tapfit::signal
