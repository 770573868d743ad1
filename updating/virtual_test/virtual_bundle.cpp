#include "updating/virtual_test/virtual_bundle.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using acquisition::HammerPulse;
using acquisition::SeededRandom;

constexpr double full_scale_volts = 5.0;

/// All runs of the test as they are made.
struct Records {
  std::vector<std::vector<HammerPulse>> pulses;
  std::vector<acquisition::SecondOrderSystem> systems;  ///< one per run
  std::vector<Eigen::MatrixXd> felt;
  ReducedTruth first;
};

double modulus_factor(const VirtualBundleSpec& spec) {
  SeededRandom random(spec.seed, "modulus");
  const double percent = spec.modulus_percent.value_or(
      2.0 * std::clamp(random.normal(), -2.0, 2.0));
  return 1.0 + percent / 100.0;
}

double value_of(const VirtualBundleSpec& spec,
                const std::string& name,
                const std::string& channel,
                double otherwise) {
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name == name && effect.places.front() == channel) {
      return effect.values.empty() ? -otherwise : effect.values[0];
    }
  }
  return otherwise;
}

// What a channel's readings are off by, its polarity aside.
double gain_of(const VirtualBundleSpec& spec, const std::string& channel) {
  return std::abs(value_of(spec, "channel-gain", channel, 1.0));
}

std::vector<std::string> channel_names(const VirtualSetup& setup) {
  std::vector<std::string> names{"hammer"};
  names.insert(
      names.end(), setup.sensor_channels.begin(), setup.sensor_channels.end());
  return names;
}

void reduce_runs(const VirtualBundleSpec& spec,
                 const VirtualSetup& setup,
                 const VirtualStructure& structure,
                 const Progress& progress,
                 Records& records) {
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

Eigen::MatrixXd feel(const VirtualBundleSpec& spec,
                     const VirtualSetup& setup,
                     const Records& records,
                     std::size_t run) {
  std::vector<double> delays;
  for (const std::string& name : channel_names(setup)) {
    delays.push_back(value_of(spec, "channel-delay", name, 0.0));
  }
  return acquisition::simulate_response(records.systems[run],
                                        records.pulses[run],
                                        acquisition::duration(setup.hand),
                                        setup.recorder,
                                        delays);
}

// An ordinary hit stays below full scale by this factor, with its scatter
// already in it.
constexpr double headroom = 1.25;

acquisition::Channel make_channel(const VirtualBundleSpec& spec,
                                  const std::string& name,
                                  double largest) {
  acquisition::Channel channel;
  channel.name = name;
  const bool force = name == "hammer";
  channel.quantity = force ? acquisition::Quantity::Force
                           : acquisition::Quantity::Acceleration;
  channel.unit = force ? "N" : "m/s^2";
  channel.full_scale_volts = full_scale_volts;
  channel.sensitivity =
      acquisition::choose_sensitivity(largest, full_scale_volts, headroom);
  if (!force) channel.mass_kg = spec.stated_mass_kg;
  return channel;
}

std::vector<acquisition::Channel> make_channels(const VirtualBundleSpec& spec,
                                                const VirtualSetup& setup,
                                                const Records& records) {
  const std::vector<std::string> names = channel_names(setup);
  Eigen::RowVectorXd largest =
      Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const Eigen::MatrixXd& felt : records.felt) {
    largest = largest.cwiseMax(felt.cwiseAbs().colwise().maxCoeff());
  }
  for (std::size_t c = 0; c < names.size(); ++c) {
    largest(static_cast<Eigen::Index>(c)) *= gain_of(spec, names[c]);
  }
  // One kind of accelerometer: all have the sensitivity that the hardest
  // pressed of them needs, so that it does not tell whose gain is off.
  const double acceleration = largest.tail(largest.size() - 1).maxCoeff();
  std::vector<acquisition::Channel> channels;
  for (std::size_t c = 0; c < names.size(); ++c) {
    channels.push_back(
        make_channel(spec, names[c], c == 0 ? largest(0) : acceleration));
  }
  return channels;
}

// A hand that hits twice in one run and far too hard in another.
void spoil_hits(const VirtualBundleSpec& spec,
                const VirtualSetup& setup,
                const std::vector<acquisition::Channel>& channels,
                Records& records) {
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
  records.felt[twice] = feel(spec, setup, records, twice);

  HammerPulse& blow = records.pulses[hard][pick(hits.size() - 1)];
  const double rate = setup.recorder.rate_hz;
  const auto begin = static_cast<Eigen::Index>(blow.begin_s * rate);
  const auto length = static_cast<Eigen::Index>(0.2 * setup.hand.gap_s * rate);
  const Eigen::MatrixXd during = records.felt[hard].middleRows(begin, length);
  double louder = 1e300;
  for (Eigen::Index c = 1; c < during.cols(); ++c) {
    const acquisition::Channel& channel = channels[static_cast<std::size_t>(c)];
    const double recorded =
        gain_of(spec, channel.name) * during.col(c).cwiseAbs().maxCoeff();
    louder = std::min(louder, channel.full_scale_si() / recorded);
  }
  blow.peak_n *= 1.5 * louder;
  records.felt[hard] = feel(spec, setup, records, hard);
}

// Noise grows with the square root of the bandwidth.
std::vector<acquisition::AnalogueChannel> make_chains(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    const std::vector<acquisition::Channel>& channels) {
  const double root_band = std::sqrt(setup.recorder.rate_hz / 2.0);
  std::vector<acquisition::AnalogueChannel> chains;
  for (const acquisition::Channel& channel : channels) {
    const bool force = channel.quantity == acquisition::Quantity::Force;
    acquisition::AnalogueChannel chain;
    chain.full_scale = channel.full_scale_si();
    chain.gain = value_of(spec, "channel-gain", channel.name, 1.0) *
                 value_of(spec, "channel-polarity", channel.name, 1.0);
    chain.noise_rms = spec.noise * (force ? 5e-4 : 2e-4) * root_band;
    chain.hum = force ? 0.006 : 0.004;
    chain.offset = 1e-3 * chain.full_scale;
    chain.drift = 0.03;
    chains.push_back(chain);
  }
  return chains;
}

std::string recording_name(int run) {
  return fmt::format("run-{:02}.flac", run);
}

// What was written down of two swapped channels: each at the other's place.
void swap_channels(const VirtualEffect& effect,
                   acquisition::TestBundle& bundle) {
  for (acquisition::Run& run : bundle.runs) {
    std::vector<Dof*> places;
    for (acquisition::Placement& sensor : run.sensors) {
      const std::string& name = bundle.channels[sensor.channel].name;
      if (std::find(effect.places.begin(), effect.places.end(), name) !=
          effect.places.end()) {
        places.push_back(&sensor.dof);
      }
    }
    if (places.size() == 2) std::swap(*places[0], *places[1]);
  }
}

// A point that is roved over is written down at another grid.
void write_wrong_grid(const VirtualEffect& effect,
                      bool roving_sensor,
                      acquisition::TestBundle& bundle) {
  const std::vector<int> grids = effect.numbers();
  const auto write = [&grids](acquisition::Placement& point) {
    if (point.dof.node == grids[0]) point.dof.node = grids[1];
  };
  for (acquisition::Run& run : bundle.runs) {
    if (!roving_sensor) {
      write(run.hammer);
      continue;
    }
    std::for_each(run.sensors.begin(), run.sensors.end(), write);
  }
}

acquisition::TestBundle describe(const VirtualBundleSpec& spec,
                                 const VirtualSetup& setup,
                                 std::vector<acquisition::Channel> channels,
                                 const fs::path& folder) {
  acquisition::TestBundle bundle;
  bundle.folder = folder;
  bundle.title = setup.title;
  bundle.deck = folder / "model.bdf";
  bundle.channels = std::move(channels);
  bundle.band_hz = setup.band_hz;
  if (!setup.model.model.materials.empty()) {
    bundle.uncertain.push_back(
        {"material", setup.model.model.materials.begin()->first, "E", 3.0});
  }
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    acquisition::Run run;
    run.file = folder / recording_name(static_cast<int>(k) + 1);
    run.hammer = {0, setup.runs[k].hammer};
    std::size_t channel = 0;
    for (const VirtualSensor& sensor : setup.runs[k].sensors) {
      run.sensors.push_back({++channel, sensor.dof});
    }
    bundle.runs.push_back(run);
  }
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name == "channel-swap") swap_channels(effect, bundle);
    if (effect.name == "wrong-grid") {
      write_wrong_grid(effect, spec.roving_sensor, bundle);
    }
  }
  return bundle;
}

// As given, and that the structure's deck is an input.
acquisition::OutputRule with_structure(acquisition::OutputRule rule,
                                       const VirtualBundleSpec& spec) {
  std::error_code ignored;
  if (!fs::is_regular_file(spec.structure, ignored)) return rule;
  for (fs::path& file : structure::deck_files(spec.structure)) {
    rule.inputs.push_back(std::move(file));
  }
  return rule;
}

// Before the work.
void check_files(const acquisition::OutputRule& rule,
                 const VirtualSetup& setup,
                 const fs::path& folder,
                 const char* truth) {
  // Work saved for another test would be taken for work on this one.
  for (const char* name : {"test.json", "model.bdf", truth, "session.json"}) {
    check_in_folder(rule, folder, name);
  }
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    check_in_folder(rule, folder, recording_name(static_cast<int>(k) + 1));
  }
}

void write_model(const VirtualSetup& setup, const fs::path& file) {
  structure::Deck deck = setup.model.model;
  if (!setup.model_cards.empty()) deck.cards = setup.model_cards;
  structure::write_deck(deck, {}, file);
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

// The whole stiffness changes evenly from the first run to the last, by the
// percentage given; in its middle the structure is as it was built.
void drift(const VirtualBundleSpec& spec, Records& records) {
  const auto last = static_cast<double>(records.systems.size()) - 1.0;
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name != "drift" || last < 1.0) continue;
    for (std::size_t k = 0; k < records.systems.size(); ++k) {
      const double time = static_cast<double>(k) / last - 0.5;
      records.systems[k].K *= 1.0 - effect.values[0] / 100.0 * time;
    }
  }
}

Records make_records(const VirtualBundleSpec& spec,
                     const VirtualSetup& setup,
                     const VirtualStructure& structure,
                     const Progress& progress) {
  Records records;
  reduce_runs(spec, setup, structure, progress, records);
  drift(spec, records);
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    progress("hits",
             static_cast<double>(k) / static_cast<double>(setup.runs.size()));
    SeededRandom random(spec.seed, "hits", k);
    records.pulses.push_back(acquisition::ordinary_hits(setup.hand, random));
    records.felt.push_back(feel(spec, setup, records, k));
  }
  return records;
}

}  // namespace

VirtualBundleSpec demo_spec() {
  VirtualBundleSpec spec;
  spec.effects = {{"sensor-mass", {}, {0.020}},
                  {"soft-support", {}, {3000.0}},
                  {"sensor-cable", {}, {0.6, 0.02}}};
  spec.stated_mass_kg = 0.020;
  return spec;
}

VirtualBundleResult make_virtual_bundle(const VirtualBundleSpec& spec,
                                        const fs::path& folder,
                                        const Progress& progress,
                                        const acquisition::OutputRule& given) {
  const VirtualSetup setup = set_up(spec);
  const acquisition::OutputRule rule = with_structure(given, spec);
  check_files(rule, setup, folder, truth_file_of(spec));
  const double factor = modulus_factor(spec);
  const VirtualStructure structure = build_virtual_structure(
      setup.model, spec.effects, factor, setup.component);
  Records records = make_records(spec, setup, structure, progress);
  const std::vector<acquisition::Channel> channels =
      make_channels(spec, setup, records);
  if (spec.faulty_hits && records.pulses.size() > 1) {
    spoil_hits(spec, setup, channels, records);
  }

  const acquisition::TestBundle bundle =
      describe(spec, setup, channels, folder);
  const std::vector<acquisition::AnalogueChannel> chains =
      make_chains(spec, setup, channels);
  acquisition::OutputFolder output(folder, rule);
  for (std::size_t k = 0; k < bundle.runs.size(); ++k) {
    progress("writing",
             static_cast<double>(k) / static_cast<double>(bundle.runs.size()));
    SeededRandom random(spec.seed, "chain", k);
    acquisition::write_audio(
        output.file(bundle.runs[k].file.filename()),
        acquisition::digitise(records.felt[k], setup.recorder, chains, random),
        static_cast<int>(setup.recorder.rate_hz),
        acquisition::AudioFormat::Flac24);
  }
  write_model(setup, output.file("model.bdf"));
  acquisition::write_file(output.file("test.json"),
                          acquisition::test_bundle_text(bundle, folder));
  write_truth(spec,
              setup,
              structure,
              records.first,
              factor,
              output.file(truth_file_of(spec)));
  output.commit();

  VirtualBundleResult result;
  result.model_hz = setup.model_hz;
  const Eigen::VectorXd& hz = records.first.frequency_hz;
  for (Eigen::Index k = 0; k < hz.size(); ++k) {
    if (hz(k) < setup.band_hz[0] || hz(k) > setup.band_hz[1]) continue;
    result.true_hz.push_back(hz(k));
    result.true_damping.push_back(records.first.damping_ratio(k));
  }
  result.runs = bundle.runs.size();
  result.seconds_per_run = acquisition::duration(setup.hand);
  result.rate_hz = setup.recorder.rate_hz;
  result.band_hz = setup.band_hz;
  result.bytes = size_of(folder);
  return result;
}

}  // namespace tapfit::updating
