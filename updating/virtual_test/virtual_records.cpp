#include "updating/virtual_test/virtual_records.hpp"

#include "acquisition/foundation/seeded_random.hpp"
#include "acquisition/simulator/virtual_test.hpp"
#include "updating/virtual_test/virtual_channels.hpp"

#include <algorithm>

namespace tapfit::updating {
namespace {

using acquisition::HammerPulse;
using acquisition::SeededRandom;

void reduce_runs(const VirtualBundleSpec& spec,
                 const VirtualSetup& setup,
                 const VirtualStructure& structure,
                 const Progress& progress,
                 VirtualRecords& records) {
  VirtualDamping damping;
  damping.mean = spec.damping_mean;
  damping.seed = spec.seed;
  const double max_hz = 4.0 * setup.band_hz[1];
  std::vector<Dof> hammers;
  for (const VirtualRun& run : setup.runs) hammers.push_back(run.hammer);
  if (!spec.roving_sensor) {
    progress("modes", 0.0);
    records.first = reduce_truth(
        structure, setup.runs[0].sensors, hammers, max_hz, damping);
    for (Eigen::Index k = 0; k < records.first.hammers.cols(); ++k) {
      records.systems.push_back(records.first.system);
      records.systems.back().input = records.first.hammers.col(k);
    }
    return;
  }
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    progress("modes",
             static_cast<double>(k) / static_cast<double>(setup.runs.size()));
    const VirtualRun& run = setup.runs[k];
    const ReducedTruth truth =
        reduce_truth(structure, run.sensors, {run.hammer}, max_hz, damping);
    if (k == 0) records.first = truth;
    records.systems.push_back(truth.system);
  }
}

Eigen::MatrixXd simulate_run(const VirtualBundleSpec& spec,
                             const VirtualSetup& setup,
                             const VirtualRecords& records,
                             std::size_t run) {
  std::vector<double> delays;
  for (const std::string& name : channel_names(setup)) {
    delays.push_back(channel_effect(spec, "channel-delay", name, 0.0));
  }
  return acquisition::simulate_response(records.systems[run],
                                        records.pulses[run],
                                        acquisition::duration(setup.hand),
                                        setup.recorder,
                                        delays);
}

// The whole stiffness changes evenly from the first run to the last, by the
// percentage given; in its middle the structure is as it was built.
void drift(const VirtualBundleSpec& spec, VirtualRecords& records) {
  const auto last = static_cast<double>(records.systems.size()) - 1.0;
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name != "drift" || last < 1.0) continue;
    for (std::size_t k = 0; k < records.systems.size(); ++k) {
      const double time = static_cast<double>(k) / last - 0.5;
      records.systems[k].K *= 1.0 - effect.values[0] / 100.0 * time;
    }
  }
}

}  // namespace

VirtualRecords make_records(const VirtualBundleSpec& spec,
                            const VirtualSetup& setup,
                            const VirtualStructure& structure,
                            const Progress& progress) {
  VirtualRecords records;
  reduce_runs(spec, setup, structure, progress, records);
  drift(spec, records);
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    progress("hits",
             static_cast<double>(k) / static_cast<double>(setup.runs.size()));
    SeededRandom random(spec.seed, "hits", k);
    records.pulses.push_back(acquisition::ordinary_hits(setup.hand, random));
    records.responses.push_back(simulate_run(spec, setup, records, k));
  }
  return records;
}

void spoil_hits(const VirtualBundleSpec& spec,
                const VirtualSetup& setup,
                const std::vector<acquisition::Channel>& channels,
                VirtualRecords& records) {
  const std::size_t runs = records.pulses.size();
  SeededRandom random(spec.seed, "faults");
  const auto pick = [&](std::size_t count) {
    return static_cast<std::size_t>(
        random.uniform(0.0, static_cast<double>(count)));
  };
  const std::size_t hard = pick(runs);
  const std::size_t twice = (hard + 1 + pick(runs - 1)) % runs;

  std::vector<HammerPulse>& hits = records.pulses[twice];
  const std::size_t hit = pick(hits.size());
  hits.push_back(acquisition::rebound(hits[hit], random));
  records.responses[twice] = simulate_run(spec, setup, records, twice);

  HammerPulse& blow = records.pulses[hard][pick(hits.size() - 1)];
  const double rate = setup.recorder.rate_hz;
  const auto begin = static_cast<Eigen::Index>(blow.begin_s * rate);
  const auto length = static_cast<Eigen::Index>(0.2 * setup.hand.gap_s * rate);
  const Eigen::MatrixXd during =
      records.responses[hard].middleRows(begin, length);
  double louder = 1e300;
  for (Eigen::Index c = 1; c < during.cols(); ++c) {
    const acquisition::Channel& channel = channels[static_cast<std::size_t>(c)];
    const double recorded =
        gain_of(spec, channel.name) * during.col(c).cwiseAbs().maxCoeff();
    louder = std::min(louder, channel.full_scale_si() / recorded);
  }
  blow.peak_n *= 1.5 * louder;
  records.responses[hard] = simulate_run(spec, setup, records, hard);
}

}  // namespace tapfit::updating
