#include "updating/virtual_test/virtual_bundle.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/virtual_test/ground_truth.hpp"
#include "updating/virtual_test/virtual_channels.hpp"
#include "updating/virtual_test/virtual_records.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_sheet.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using acquisition::SeededRandom;

double modulus_factor(const VirtualBundleSpec& spec) {
  SeededRandom random(spec.seed, "modulus");
  const double percent = spec.modulus_percent.value_or(
      2.0 * std::clamp(random.normal(), -2.0, 2.0));
  return 1.0 + percent / 100.0;
}

// As given, and that the structure's decks are inputs.
acquisition::OutputRule with_structure(acquisition::OutputRule rule,
                                       const VirtualBundleSpec& spec) {
  for (const std::string& deck : {spec.structure, spec.truth}) {
    std::error_code ignored;
    if (!fs::is_regular_file(deck, ignored)) continue;
    for (fs::path& file : structure::deck_files(deck)) {
      rule.inputs.push_back(std::move(file));
    }
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
  structure::write_deck(deck, {}, file, {});
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

VirtualBundleResult summary_of(const VirtualSetup& setup,
                               const ReducedTruth& truth) {
  VirtualBundleResult result;
  result.model_hz = setup.model_hz;
  const Eigen::VectorXd& hz = truth.frequency_hz;
  for (Eigen::Index k = 0; k < hz.size(); ++k) {
    if (hz(k) < setup.band_hz[0] || hz(k) > setup.band_hz[1]) continue;
    result.true_hz.push_back(hz(k));
    result.true_damping.push_back(truth.damping_ratio(k));
  }
  result.seconds_per_run = acquisition::duration(setup.hand);
  result.rate_hz = setup.recorder.rate_hz;
  result.band_hz = setup.band_hz;
  return result;
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
  VirtualRecords records = make_records(spec, setup, structure, progress);
  const std::vector<acquisition::Channel> channels =
      make_channels(spec, setup, records.responses);
  if (spec.faulty_hits && records.pulses.size() > 1) {
    spoil_hits(spec, setup, channels, records);
  }

  const acquisition::TestBundle bundle =
      test_sheet(spec, setup, channels, folder);
  const std::vector<acquisition::AnalogueChannel> chains =
      make_chains(spec, setup, channels);
  acquisition::OutputFolder output(folder, rule);
  for (std::size_t k = 0; k < bundle.runs.size(); ++k) {
    progress("writing",
             static_cast<double>(k) / static_cast<double>(bundle.runs.size()));
    SeededRandom random(spec.seed, "chain", k);
    output.write(bundle.runs[k].file.filename(), [&](const fs::path& file) {
      acquisition::write_audio(
          file,
          acquisition::digitise(
              records.responses[k], setup.recorder, chains, random),
          static_cast<int>(setup.recorder.rate_hz),
          acquisition::AudioFormat::Flac24);
    });
  }
  output.write("model.bdf",
               [&](const fs::path& file) { write_model(setup, file); });
  output.write("test.json", acquisition::test_bundle_text(bundle, folder));
  output.write(truth_file_of(spec), [&](const fs::path& file) {
    write_ground_truth(spec, setup, structure, records.first, factor, file);
  });
  output.commit();

  VirtualBundleResult result = summary_of(setup, records.first);
  result.runs = bundle.runs.size();
  result.bytes = size_of(folder);
  return result;
}

}  // namespace tapfit::updating
