#include "tui/practice/challenge_command.hpp"

#include "tui/options/own_answer.hpp"
#include "tui/options/standard_streams.hpp"
#include "updating/export/output_rule_of_folder.hpp"
#include "updating/practice/challenge.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace tapfit::tui {
namespace {

struct Words {
  std::string folder;
  std::uint64_t seed = 0;
  std::string level = "easy";
  std::string structure;
};

void describe(CLI::App& app, Words& words) {
  app.add_option("-o,--output", words.folder, "folder to make")->required();
  app.add_option("--seed", words.seed, "same seed and level, same test")
      ->required();
  app.add_option("--level", words.level, "easy (one effect) or hard")
      ->check(CLI::IsMember({"easy", "hard"}));
  app.add_option("--structure", words.structure, "else it is drawn")
      ->check(CLI::IsMember(updating::virtual_structures()));
}

std::string invitation(const updating::VirtualBundleSpec& spec,
                       const updating::VirtualBundleResult& made,
                       const Words& words) {
  const char* hides = words.level == "easy"
                          ? "One effect is missing from its model."
                          : "None, one or two effects are missing from its "
                            "model, which may be off in its modulus, too.";
  return fmt::format(
      "{0}: hammer test of the {1}, {2} runs, {3:g} to {4:g} Hz, {5:.1f} MB\n"
      "{6}\n"
      "play    tapfit {0}\n"
      "then    tapfit reveal {0}\n",
      words.folder,
      spec.structure,
      made.runs,
      made.band_hz[0],
      made.band_hz[1],
      static_cast<double>(made.bytes) / 1e6,
      hides);
}

}  // namespace

int challenge_command(int argc,
                      const char* const* argv,
                      const Progress& progress) {
  CLI::App app("Makes a hammer test that hides something, to be found",
               "tapfit challenge");
  Words words;
  describe(app, words);
  if (const auto status = answered(app, argc, argv)) return *status;
  const auto level = words.level == "easy" ? updating::ChallengeLevel::Easy
                                           : updating::ChallengeLevel::Hard;
  const updating::VirtualBundleSpec spec =
      updating::draw_challenge(level, words.seed, words.structure);
  const updating::VirtualBundleResult made = updating::make_virtual_bundle(
      spec,
      words.folder,
      progress,
      updating::output_rule_of_folder(words.folder, false));
  print(invitation(spec, made, words));
  return 0;
}

}  // namespace tapfit::tui
