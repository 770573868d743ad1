#include "tui/practice/simulate_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/options/own_answer.hpp"
#include "tui/options/standard_streams.hpp"
#include "updating/export/output_rule_of_folder.hpp"
#include "updating/virtual_test/made_files.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace tapfit::tui {
namespace {

using updating::VirtualBundleResult;
using updating::VirtualBundleSpec;

/// The command line as written.
struct SimulateWords {
  std::string folder;
  std::vector<std::string> effects;
  std::string roving = "hammer";
  std::vector<double> band;
  bool force = false;
  VirtualBundleSpec spec;
};

/// What is wrong with an effect as written; empty where nothing is.
std::string effect_fault(const std::string& text) {
  if (text == "none") return {};
  try {
    static_cast<void>(updating::parse_virtual_effect(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

void describe_simulate(CLI::App& app, SimulateWords& words) {
  VirtualBundleSpec& spec = words.spec;
  app.add_option("folder", words.folder, "folder to make")->required();
  app.add_option("--structure",
                 spec.structure,
                 fmt::format("{} or a Nastran deck",
                             fmt::join(updating::virtual_structures(), ", ")));
  app.add_option("--truth",
                 spec.truth,
                 "deck of what the structure really is, with the same grids "
                 "among its own")
      ->needs("--structure");
  app.add_option(
         "--effect", words.effects, "what to hide, or none; may be repeated")
      ->expected(1)
      ->take_all()
      ->check(CLI::Validator(effect_fault, "EFFECT[@PLACE][=VALUE,...]"));
  app.add_option("--seed", spec.seed, "same seed, same bundle")
      ->capture_default_str();
  app.add_option("--roving", words.roving, "hammer or sensor")
      ->capture_default_str()
      ->check(CLI::IsMember({"hammer", "sensor"}));
  app.add_option("--runs", spec.points, "points to rove over")
      ->capture_default_str()
      ->check(CLI::Range(2, 999));
  app.add_option("--hits", spec.hits, "hits at each point")
      ->capture_default_str()
      ->check(CLI::Range(1, 99));
  app.add_option("--band", words.band, "band of interest [Hz]")
      ->expected(2)
      ->delimiter(',');
  app.add_option("--gap", spec.gap_s, "time between hits [s]")
      ->capture_default_str()
      ->check(CLI::Range(0.05, 600.0));
  app.add_option("--modulus", spec.modulus_percent, "E off by [%]")
      ->capture_default_str()
      ->check(CLI::Range(-50.0, 50.0));
  app.add_option("--damping", spec.damping_mean, "mean damping ratio")
      ->capture_default_str()
      ->check(CLI::Range(1e-5, 0.2));
  app.add_option("--stated-mass",
                 spec.stated_mass_kg,
                 "sensor mass on the maker's sheet [kg]")
      ->check(CLI::Range(0.0, 100.0));
  app.add_flag("!--no-faulty-hits",
               spec.faulty_hits,
               "leave out the double hit and the overload");
  app.add_flag("--force",
               words.force,
               "replace a test as it was made before; never a measured one");
  app.footer("Effects:\n" + updating::virtual_effect_help() +
             "Without --structure and --effect the demo is made.");
}

void check_band(const std::vector<double>& band) {
  if (band.empty() || (band[0] > 0.0 && band[1] > band[0])) return;
  throw CLI::ValidationError("--band",
                             "give the lower frequency first, above 0 Hz");
}

VirtualBundleSpec spec_of(const CLI::App& app, const SimulateWords& words) {
  VirtualBundleSpec spec = words.spec;
  if (app.count("--effect") == 0 && spec.structure == "frame") {
    const VirtualBundleSpec demo = updating::demo_spec();
    spec.effects = demo.effects;
    if (!spec.stated_mass_kg) spec.stated_mass_kg = demo.stated_mass_kg;
  }
  for (const std::string& text : words.effects) {
    if (text == "none") continue;
    spec.effects.push_back(updating::parse_virtual_effect(text));
  }
  spec.roving_sensor = words.roving == "sensor";
  if (!words.band.empty()) spec.band_hz = {words.band[0], words.band[1]};
  return spec;
}

std::string summary(const VirtualBundleResult& result,
                    const std::string& folder) {
  std::string text = fmt::format(
      "{}: {} runs of {:.0f} s at {:.0f} Hz, {:.1f} MB\n"
      "band {:g} to {:g} Hz\n"
      "model [Hz]    {:.2f}\n"
      "measured [Hz] {:.2f}\n"
      "damping [%]   ",
      folder,
      result.runs,
      result.seconds_per_run,
      result.rate_hz,
      static_cast<double>(result.bytes) / 1e6,
      result.band_hz[0],
      result.band_hz[1],
      fmt::join(result.model_hz, "  "),
      fmt::join(result.true_hz, "  "));
  for (const double zeta : result.true_damping) {
    text += fmt::format("{:.2f}  ", 100.0 * zeta);
  }
  return text + "\nWhat is hidden stands in truth.json.\n";
}

}  // namespace

int simulate_command(int argc,
                     const char* const* argv,
                     const Progress& progress) {
  CLI::App app("Makes a hammer test of a structure with a hidden effect",
               "tapfit simulate");
  SimulateWords words;
  describe_simulate(app, words);
  const auto check = [&words] { check_band(words.band); };
  if (const auto status = answered(app, argc, argv, check)) return *status;
  const VirtualBundleSpec spec = spec_of(app, words);
  const VirtualBundleResult result = updating::make_virtual_bundle(
      spec,
      words.folder,
      progress,
      updating::output_rule_of_folder(
          words.folder, words.force, updating::made_files(words.folder)));
  print(summary(result, words.folder));
  return 0;
}

}  // namespace tapfit::tui
