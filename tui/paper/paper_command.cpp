#include "tui/paper/paper_command.hpp"

#include "signal/files/uff58.hpp"
#include "tui/paper/paper_structures.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/studies/truss_study.hpp"
#include "updating/studies/wing_study.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

struct Structure {
  const char* name;
  const char* folder;
  PaperReport (*work)(const fs::path& folder, const Progress& progress);
};

constexpr std::array<Structure, 3> structures{{
    {"truss", "paper-truss", paper_truss},
    {"wing", "paper-solar-wing", paper_wing},
    {"frame", "solar-panel-frame", paper_frame},
}};

// The simulated FRFs that the bundles hold, made again beside them.
std::string write_measured(const CommandOptions& options) {
  const updating::TrussStudy truss(options.input / structures[0].folder);
  const updating::WingStudy wing(options.input / structures[1].folder);
  const fs::path of_truss = *options.paper.write / "paper-truss.uff";
  const fs::path of_wing = *options.paper.write / "paper-solar-wing.uff";
  acquisition::OutputRule rule{{}, options.force};
  for (const acquisition::TestBundle* bundle :
       {&truss.study().bundle(), &wing.study().bundle()}) {
    const acquisition::OutputRule one =
        updating::output_rule_of(*bundle, options.force, {of_truss});
    rule.inputs.insert(rule.inputs.end(), one.inputs.begin(), one.inputs.end());
  }
  rule.check({of_truss, of_wing});
  signal::write_frfs_uff(
      truss.measured(1), truss.study().bundle().title, of_truss, rule);
  signal::write_frfs_uff(
      wing.measured(1), wing.study().bundle().title, of_wing, rule);
  return "written: " + of_truss.string() + "\nwritten: " + of_wing.string() +
         "\n";
}

}  // namespace

std::string paper_command(const CommandOptions& options,
                          const Progress& progress) {
  if (options.paper.write) return write_measured(options);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  std::string text;
  for (const Structure& structure : structures) {
    const auto& named = options.paper.structures;
    const bool wanted = named.empty() ||
                        std::ranges::find(named, structure.name) != named.end();
    if (!wanted) continue;
    const PaperReport report =
        structure.work(options.input / structure.folder, progress);
    all.push_back(paper_json(report));
    text += (text.empty() ? "" : "\n") + paper_text(report);
  }
  return options.json ? json_text(nlohmann::ordered_json{{"structures", all}})
                      : text;
}

void add_paper_options(CLI::App& command, CommandOptions& options) {
  command
      .add_option("STRUCTURE",
                  options.paper.structures,
                  "truss, wing, frame; all where none is named")
      ->check(CLI::IsMember({"truss", "wing", "frame"}));
  command
      .add_option("--recordings",
                  options.input,
                  "Folder of the bundles (those that come with the program)")
      ->type_name("FOLDER");
  command
      .add_option("--write",
                  options.paper.write,
                  "Folder for the simulated FRFs of truss and wing, made "
                  "again")
      ->type_name("FOLDER");
  command.add_flag("--force",
                   options.force,
                   "Replace files that are there; never what the test reads");
  command.add_flag("--json", options.json, "Print one JSON object");
}

}  // namespace tapfit::tui
