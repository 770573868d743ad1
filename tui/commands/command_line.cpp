#include "tui/commands/command_line.hpp"

#include "tui/commands/command_table.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/help_format.hpp"
#include "tui/options/library_versions.hpp"
#include "tui/options/misspelt.hpp"
#include "tui/options/option_groups.hpp"
#include "tui/options/recordings_folder.hpp"
#include "tui/options/terminal_options.hpp"
#include "tui/paper/paper_command.hpp"
#include "tui/practice/challenge_command.hpp"
#include "tui/practice/score_command.hpp"
#include "tui/practice/simulate_command.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace tapfit::tui {
namespace {

using enum CommandEntry::Option;

/// A command that reads its own command line.
struct OwnEntry {
  const char* name;
  const char* does;
  OwnCommand own;
};

constexpr std::array<OwnEntry, 3> own_entries{{
    {"simulate", "Make a bundle by a virtual test", simulate_command},
    {"challenge",
     "Make a bundle that hides something, to be found",
     challenge_command},
    {"score", "Diagnose practice cases and count", score_command},
}};

/// What is done with the published tables and with made-up tests.
constexpr const char* studies = "Studies and practice";

const char* group_of(std::string_view command) {
  for (const std::string_view study :
       {"paper", "simulate", "challenge", "reveal", "score"}) {
    if (command == study) return studies;
  }
  return "Commands";
}

CLI::App* add_subcommand(CLI::App& app,
                         const std::string& name,
                         const std::string& does) {
  CLI::App* command = app.add_subcommand(name, does);
  command->group(group_of(name));
  command->footer(example_of(name));
  return command;
}

/// Of what a command reads.
std::string input_words(std::string_view input) {
  using Pair = std::pair<std::string_view, const char*>;
  static constexpr std::array<Pair, 5> known{{
      {"BUNDLE", "Folder of a test, with its test.json, or a universal file"},
      {"MODES", "UFF 55 or 2414, CSV or JSON"},
      {"DECK", "Bulk data, or a deck of Abaqus or CalculiX (.inp)"},
      {"FILE", "Universal file"},
      {"FOLDER", "Where the challenge is"},
  }};
  const auto found = std::ranges::find(known, input, &Pair::first);
  return found == known.end() ? "" : found->second;
}

void add_inside(CLI::App& command, CommandOptions& options) {
  command.add_flag("--inside",
                   options.inside,
                   "Refuse a test that reads from outside its folder");
}

/// One of the tables that the JSON holds, the command's own where none is
/// named.
void add_formats(CLI::App& command,
                 const CommandEntry& entry,
                 CommandOptions& options) {
  auto* json =
      command.add_flag("--json", options.json, "Print one JSON object");
  if (entry.table == nullptr) return;
  command
      .add_flag(fmt::format("--csv{{{}}}", entry.table),
                options.csv,
                fmt::format("Print the table {} of that as CSV; --csv=TABLE: "
                            "another of its tables",
                            entry.table))
      ->excludes(json);
}

void add_command(CLI::App& app,
                 const CommandEntry& entry,
                 Invocation& invocation) {
  CLI::App* command = add_subcommand(app, entry.name, entry.does);
  if (entry.alias != nullptr) command->alias(entry.alias);
  CommandOptions& options = invocation.options;
  const auto has = [&entry](unsigned extra) {
    return (entry.extras & extra) != 0;
  };
  if (entry.input != nullptr) {
    command->add_option(entry.input, options.input, input_words(entry.input))
        ->required();
    add_inside(*command, options);
  }
  if (has(Several)) add_together_options(*command, options);
  if (!has(TextOnly)) add_formats(*command, entry, options);
  if (has(Uff)) {
    command->add_option("--uff", options.uff, "Universal file to write")
        ->type_name("FILE");
  }
  if (has(DeckFile)) add_export_options(*command, options);
  if (has(Output)) {
    command
        ->add_option("-o,--output",
                     options.output,
                     "Report to write: .html, or .md with pictures beside it "
                     "(BUNDLE/report.html)")
        ->type_name("FILE");
  }
  if (has(Uff | DeckFile | Output | Identify)) {
    command->add_flag("--force",
                      options.force,
                      "Replace files that are there; never what the test "
                      "reads");
  }
  if (has(SavedFile)) {
    command
        ->add_option(
            "--file", options.saved, "Saved session (BUNDLE/session.json)")
        ->type_name("FILE");
  }
  if (has(Effects)) add_effects(*command, options);
  if (has(Forecast)) add_predict_options(*command, options);
  if (has(Free)) add_free_masses(*command, options);
  if (has(Regularisation)) add_regularisation(*command, options);
  if (has(Mac)) {
    command->add_option("OTHER", options.other, "Modes to compare with");
  }
  if (has(Identify)) add_modes_options(*command, options.identification);
  if (has(ByHand)) add_mode_choices(*command, options.by_hand);
  if (has(Robustness)) {
    command->add_flag("--robustness",
                      options.robustness,
                      "What becomes of the verdict when a prior, the allowance "
                      "for form or a run is changed or left out");
  }
  if (has(Pairs)) add_pair_choices(*command, options.by_hand);
  if (has(Mass | BodyMass)) {
    command
        ->add_option(
            "--mass", options.mass_kg, "Of the free body with its sensors [kg]")
        ->required(has(Mass))
        ->check(CLI::PositiveNumber);
  }
  if (has(Speed)) {
    command
        ->add_option("--speed",
                     options.speed,
                     "Times real time; 0 (default): as fast as it goes")
        ->check(CLI::NonNegativeNumber);
  }
  if (has(Estimate)) add_estimate(*command, options.frf);
  if (has(Modes)) {
    command->add_option("--modes", options.modes, "How many modes")
        ->check(CLI::Range(1, 10000));
    command->add_option("--ignore-card",
                        options.ignored_cards,
                        "Leaves cards of this name out, though they carry "
                        "stiffness, mass or a constraint");
    command
        ->add_option("--units",
                     options.units,
                     "Of the deck, in place of the bundle's or SI")
        ->check(CLI::IsMember({"SI", "mm-t-s", "in-lbf-s"}));
  }
  if (has(Node)) {
    command->add_option("NODE", options.node, "Grid id; none for a map of all")
        ->check(CLI::Range(1, 99999999));
  }
  if (has(DeckFile)) {
    command->parse_complete_callback([&options] { check_has_export(options); });
  }
  command->callback([&invocation, &entry] {
    invocation.name = entry.name;
    invocation.command = entry.command;
  });
}

void add_import(CLI::App& app, Invocation& invocation) {
  CLI::App* command = add_subcommand(
      app,
      "import",
      "Make a bundle out of time records: CSV, MATLAB, HDF5 and netCDF4, TDMS, "
      "numpy, SEP-005, universal files");
  add_import_options(*command, invocation.options);
  command->callback([&invocation] {
    invocation.name = "import";
    invocation.command = import_command;
  });
}

void add_tour(CLI::App& app, Invocation& invocation) {
  CLI::App* command = add_subcommand(
      app,
      "tour",
      "The terminal with words on what is seen: of the demonstration");
  add_terminal_options(*command, invocation.options.input, invocation.app);
  add_inside(*command, invocation.options);
  command->callback([&invocation] {
    invocation.name = "tour";
    invocation.app.tour = true;
  });
}

void add_paper(CLI::App& app, Invocation& invocation) {
  CLI::App* command = add_subcommand(
      app, "paper", "The published tables beside the program's own");
  add_paper_options(*command, invocation.options);
  command->callback([&invocation] {
    invocation.name = "paper";
    invocation.command = paper_command;
    if (invocation.options.input.empty()) {
      invocation.options.input = recordings_folder();
    }
  });
}

void add_own(CLI::App& app, const OwnEntry& entry, Invocation& invocation) {
  CLI::App* command = add_subcommand(app, entry.name, entry.does);
  command->set_help_flag();
  command->prefix_command();
  command->callback([&invocation, &entry, command] {
    invocation.name = entry.name;
    invocation.own = entry.own;
    invocation.passed_on = command->remaining();
  });
}

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : library_versions()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : "\n  ", name, version);
  }
  return text;
}

/// "tapfit help modes" as "tapfit modes --help".
std::vector<std::string> arguments_of(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  std::error_code fault;
  if (arguments.empty() || arguments.front() != "help" ||
      std::filesystem::exists("help", fault)) {
    return arguments;
  }
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return arguments;
}

CommandLineAnswer answer_to(const CLI::App& app,
                            const CLI::ParseError& error,
                            const std::string& misspelt) {
  std::ostringstream out;
  std::ostringstream err;
  if (app.exit(error, out, err) == 0) return {0, out.str()};
  const std::string words = misspelt.empty() ? meant_words(app) : misspelt;
  return {2, plain_words(err.str()) + words};
}

}  // namespace

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandEntry& entry : command_table())
    names.emplace_back(entry.name);
  names.emplace_back("tour");
  names.emplace_back("import");
  names.emplace_back("paper");
  for (const OwnEntry& entry : own_entries) names.emplace_back(entry.name);
  return names;
}

std::variant<Invocation, CommandLineAnswer> parse_command_line(
    int argc, const char* const* argv) {
  Invocation invocation;
  CLI::App app(
      "From hammer taps to a finite element model you can believe.\n"
      "Without a command, opens the bundle in the terminal.",
      "tapfit");
  app.formatter(std::make_shared<HelpFormat>());
  app.footer("tapfit COMMAND --help lists what a command can be told.");
  app.set_version_flag("--version", version_text, "Print the libraries' too");
  app.require_subcommand(0, 1);
  add_terminal_options(app, invocation.options.input, invocation.app);
  add_inside(app, invocation.options);
  for (const CommandEntry& entry : command_table())
    add_command(app, entry, invocation);
  add_tour(app, invocation);
  add_import(app, invocation);
  add_paper(app, invocation);
  const auto misspelt = [&] {
    const std::filesystem::path& input = invocation.options.input;
    std::error_code fault;
    return app.get_subcommands().empty() &&
                   !std::filesystem::exists(input, fault)
               ? meant_command(app, input.string())
               : std::string();
  };
  for (const OwnEntry& entry : own_entries) add_own(app, entry, invocation);
  try {
    std::vector<std::string> arguments = arguments_of(argc, argv);
    std::ranges::reverse(arguments);  // as CLI11 wants them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return answer_to(app, error, misspelt());
  }
  if (!invocation.options.csv.empty()) invocation.options.json = true;
  if (!invocation.name.empty()) return invocation;
  if (!invocation.options.input.empty()) {
    const std::string meant = misspelt();
    if (meant.empty()) return invocation;
    return CommandLineAnswer{
        2,
        fmt::format("There is neither a bundle nor a command \"{}\".\n{}",
                    invocation.options.input.string(),
                    meant)};
  }
  if (invocation.app.keys_file) return CommandLineAnswer{2, app.help()};
  invocation.help = app.help();
  return invocation;
}

}  // namespace tapfit::tui
