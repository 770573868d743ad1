#include "tui/commands/command_line.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/mass_removal/named_masses.hpp"
#include "tui/commands/calibrate_command.hpp"
#include "tui/commands/check_command.hpp"
#include "tui/commands/compare_command.hpp"
#include "tui/commands/diagnose_command.hpp"
#include "tui/commands/export_command.hpp"
#include "tui/commands/free_masses.hpp"
#include "tui/commands/frf_command.hpp"
#include "tui/commands/hits_command.hpp"
#include "tui/commands/import_command.hpp"
#include "tui/commands/mac_command.hpp"
#include "tui/commands/model_command.hpp"
#include "tui/commands/modes_command.hpp"
#include "tui/commands/replay_command.hpp"
#include "tui/commands/report_command.hpp"
#include "tui/commands/run_command.hpp"
#include "tui/commands/session_command.hpp"
#include "tui/commands/signature_command.hpp"
#include "tui/commands/uff_command.hpp"
#include "tui/commands/update_command.hpp"
#include "tui/options/export_options.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/modes_options.hpp"
#include "tui/options/terminal_options.hpp"
#include "tui/paper/paper_command.hpp"
#include "tui/practice/challenge_command.hpp"
#include "tui/practice/reveal_command.hpp"
#include "tui/practice/score_command.hpp"
#include "tui/practice/simulate_command.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/fit/line_rule.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <sstream>

namespace tapfit::tui {
namespace {

/// Options a command has besides --json.
enum Extra : unsigned {
  None = 0,
  Uff = 1,
  DeckFile = 2,
  Output = 4,
  Effects = 8,
  TextOnly = 128,
  Modes = 16,
  Node = 32,
  SavedFile = 64,
  Free = 256,
  Regularisation = 512,
  Identify = 1024,
  Mac = 2048,
  Speed = 4096,
  Estimate = 8192,
  Mass = 16384,
  ByHand = 32768,
  Pairs = 65536,
  BodyMass = 131072,
  Robustness = 262144,
};

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

struct Entry {
  const char* name;
  const char* does;
  Command command;
  unsigned extras;
  const char* input = "BUNDLE";
  const char* alias = nullptr;  ///< an older name
};

constexpr std::array<Entry, 18> entries{{
    {"run",
     "The whole chain, recording to error ladder",
     run_command,
     ByHand | Pairs},
    {"hits", "Hits found and judged", hits_command, None},
    {"frf",
     "Frequency response functions and their quality",
     frf_command,
     Uff | Free | Estimate},
    {"check",
     "Check a test before any model",
     check_command,
     BodyMass,
     "BUNDLE",
     "quality"},
    {"calibrate",
     "Sensors against the hammer, on a known mass",
     calibrate_command,
     Mass},
    {"replay",
     "The test as if it were being measured",
     replay_command,
     Uff | Speed},
    {"modes", "Identified modes", modes_command, Uff | Identify | ByHand},
    {"mac",
     "Two sets of modes against each other, or one against itself",
     mac_command,
     Mac | Pairs,
     "MODES"},
    {"model", "Summarise a deck, and its modes", model_command, Modes, "DECK"},
    {"uff", "What a universal file holds", uff_command, None, "FILE"},
    {"compare", "Model against measurement", compare_command, ByHand | Pairs},
    {"diagnose",
     "What is missing from the model",
     diagnose_command,
     ByHand | Robustness},
    {"signature",
     "Missing dynamic stiffness at a grid",
     signature_command,
     Node},
    {"update",
     "Identify uncertain properties and the effects named",
     update_command,
     Effects | Regularisation | ByHand | Pairs},
    {"session", "Re-run a saved session", session_command, SavedFile | Output},
    {"report",
     "A report of the finished work, HTML or Markdown",
     report_command,
     Output | TextOnly | ByHand | Pairs},
    {"export",
     "Write FRFs, modes and the updated deck",
     export_command,
     Uff | DeckFile | Effects},
    {"reveal",
     "What a challenge hides, beside what was found",
     reveal_command,
     None,
     "FOLDER"},
}};

/// What is wrong with an effect as written; empty where nothing is.
std::string effect_fault(const std::string& text) {
  try {
    static_cast<void>(updating::parse_effect(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// What is wrong with a mass as written; empty where nothing is.
std::string free_fault(const std::string& text) {
  return signal::parse_free(text)
             ? std::string{}
             : "\"" + text + "\" is not SENSOR[=KG][,sd=KG]";
}

std::string lines_fault(const std::string& text) {
  try {
    static_cast<void>(updating::parse_lines(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string lambda_fault(const std::string& text) {
  double value = 0.0;
  const bool number = CLI::detail::lexical_cast(text, value) &&
                      std::isfinite(value) && value >= 0.0;
  return number || text == "l-curve"
             ? std::string()
             : "\"" + text + "\" is neither a number from 0 on nor l-curve";
}

void add_regularisation(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--lines",
                  options.lines,
                  "Frequency lines: damped, rule, even, random, before-peaks "
                  "or a list in Hz such as 20,31.5,40:60:0.5")
      ->check(CLI::Validator(lines_fault, "LINES"));
  command
      .add_option("--lambda",
                  options.lambda,
                  "Tikhonov regularisation instead of the prior")
      ->check(CLI::Validator(lambda_fault, "VALUE|l-curve"));
}

void add_estimate(CLI::App& command, FrfArguments& frf) {
  command.add_option("--estimator", frf.estimator, "H1 (default), H2 or Hv")
      ->check(CLI::IsMember({"H1", "H2", "Hv"}));
  command
      .add_option(
          "--form", frf.form, "accelerance (default), mobility or receptance")
      ->check(CLI::IsMember({"accelerance", "mobility", "receptance"}));
  auto* window = command
                     .add_option("--window",
                                 frf.window,
                                 "Value of the exponential window at the "
                                 "block's end (0.01; 1: none)")
                     ->check(CLI::Range(1e-6, 1.0));
  command
      .add_option(
          "--sigma", frf.sigma, "On the line s = sigma + j omega, sigma in 1/s")
      ->check(CLI::NonNegativeNumber)
      ->excludes(window);
  command.add_flag("--best-hits",
                   frf.best_hits,
                   "Without hits that stand apart from the others");
}

void add_inside(CLI::App& command, CommandOptions& options) {
  command.add_flag("--inside",
                   options.inside,
                   "Refuse a test that reads from outside its folder");
}

void add_force(CLI::App& command, CommandOptions& options) {
  command.add_flag("--force",
                   options.force,
                   "Replace files that are there; never what the test reads");
}

void add_command(CLI::App& app, const Entry& entry, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(entry.name, entry.does);
  if (entry.alias != nullptr) command->alias(entry.alias);
  CommandOptions& options = invocation.options;
  command->add_option(entry.input, options.input)->required();
  add_inside(*command, options);
  if ((entry.extras & TextOnly) == 0) {
    command->add_flag("--json", options.json, "Print one JSON object");
  }
  if ((entry.extras & Uff) != 0) {
    command->add_option("--uff", options.uff, "Universal file to write");
  }
  if ((entry.extras & DeckFile) != 0) add_export_options(*command, options);
  if ((entry.extras & Output) != 0) {
    command->add_option("-o,--output", options.output, "Where to write");
  }
  if ((entry.extras & (Uff | DeckFile | Output | Identify)) != 0) {
    add_force(*command, options);
  }
  if ((entry.extras & SavedFile) != 0) {
    command->add_option(
        "--file", options.saved, "Saved session (BUNDLE/session.json)");
  }
  if ((entry.extras & Effects) != 0) {
    command
        ->add_option("--effect",
                     options.effects,
                     "Effect to add, for example added-mass@201")
        ->check(CLI::Validator(effect_fault, "EFFECT[@PLACE]"))
        ->allow_extra_args(false);
  }
  if ((entry.extras & Free) != 0) {
    command
        ->add_option("--free",
                     options.free,
                     "Take a sensor's mass off: all, acc1, acc1=0.020 or "
                     "acc1=0.020,sd=0.001 [kg]; again for each")
        ->check(CLI::Validator(free_fault, "SENSOR[=KG][,sd=KG]"))
        ->allow_extra_args(false);
  }
  if ((entry.extras & Regularisation) != 0) {
    add_regularisation(*command, options);
  }
  if ((entry.extras & Mac) != 0) {
    command->add_option("OTHER", options.other, "Modes to compare with");
  }
  if ((entry.extras & Identify) != 0) {
    add_modes_options(*command, options.identification);
  }
  if ((entry.extras & ByHand) != 0) {
    add_mode_choices(*command, options.by_hand);
  }
  if ((entry.extras & Robustness) != 0) {
    command->add_flag("--robustness",
                      options.robustness,
                      "What becomes of the verdict when a prior, the allowance "
                      "for form or a run is changed or left out");
  }
  if ((entry.extras & Pairs) != 0) add_pair_choices(*command, options.by_hand);
  if ((entry.extras & (Mass | BodyMass)) != 0) {
    command
        ->add_option(
            "--mass", options.mass_kg, "Of the free body with its sensors [kg]")
        ->required((entry.extras & Mass) != 0)
        ->check(CLI::PositiveNumber);
  }
  if ((entry.extras & Speed) != 0) {
    command
        ->add_option("--speed",
                     options.speed,
                     "Times real time; 0 (default): as fast as it goes")
        ->check(CLI::NonNegativeNumber);
  }
  if ((entry.extras & Estimate) != 0) add_estimate(*command, options.frf);
  if ((entry.extras & Modes) != 0) {
    command->add_option("--modes", options.modes, "How many modes")
        ->check(CLI::Range(1, 10000));
    command->add_option("--ignore-card",
                        options.ignored_cards,
                        "Leaves cards of this name out, though they carry "
                        "stiffness, mass or a constraint");
  }
  if ((entry.extras & Node) != 0) {
    command->add_option("NODE", options.node, "Grid id; none for a map of all")
        ->check(CLI::Range(1, 99999999));
  }
  command->callback([&invocation, &entry] {
    invocation.name = entry.name;
    invocation.command = entry.command;
  });
}

void add_import(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "import", "Make a bundle out of CSV, MATLAB, SEP-005 or universal files");
  CommandOptions& options = invocation.options;
  ImportArguments& given = options.imports;
  command->add_option("FILE", given.files, "FILE, or FILE@POINT of its blows")
      ->required();
  command->add_option("-o,--output", options.output, "Folder of the bundle")
      ->required();
  command->add_option("--hammer", given.hammer, "COLUMN@POINT,KEY=VALUE...")
      ->required();
  command->add_option("--sensor", given.sensors, "COLUMN@POINT,KEY=VALUE...")
      ->required()
      ->allow_extra_args(false);
  command->add_option(
      "--rate",
      given.rate,
      "Samples per second, or a variable of a .mat file that says it");
  command->add_option("--time", given.time_column, "Column of the time [s]");
  command->add_option("--title", given.title, "Title of the bundle");
  command->add_option("--deck", options.deck, "Its bulk data model");
  command->add_option("--band", given.band_hz, "Lowest and highest frequency")
      ->delimiter(',');
  add_force(*command, options);
  command->add_flag("--json", options.json, "Print one JSON object");
  command->callback([&invocation] {
    invocation.name = "import";
    invocation.command = import_command;
  });
}

void add_paper(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "paper", "The published tables beside the program's own");
  CommandOptions& options = invocation.options;
  command
      ->add_option("STRUCTURE",
                   options.paper.structures,
                   "truss, wing, frame; all where none is named")
      ->check(CLI::IsMember({"truss", "wing", "frame"}));
  command->add_option(
      "--recordings", options.input, "Folder of the bundles (recordings)");
  command->add_option("--write",
                      options.paper.write,
                      "Folder for the simulated FRFs of truss and wing, made "
                      "again");
  add_force(*command, options);
  command->add_flag("--json", options.json, "Print one JSON object");
  command->callback([&invocation] {
    invocation.name = "paper";
    invocation.command = paper_command;
    if (invocation.options.input.empty()) {
      invocation.options.input = "recordings";
    }
  });
}

void add_own(CLI::App& app, const OwnEntry& entry, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(entry.name, entry.does);
  command->set_help_flag();
  command->prefix_command();
  command->callback([&invocation, &entry, command] {
    invocation.name = entry.name;
    invocation.own = entry.own;
    invocation.passed_on = command->remaining();
  });
}

}  // namespace

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
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
  app.set_version_flag("--version", "tapfit " TAPFIT_VERSION);
  app.require_subcommand(0, 1);
  add_terminal_options(app, invocation.options.input, invocation.app);
  add_inside(app, invocation.options);
  for (const Entry& entry : entries) add_command(app, entry, invocation);
  add_import(app, invocation);
  add_paper(app, invocation);
  for (const OwnEntry& entry : own_entries) add_own(app, entry, invocation);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const bool fault = app.exit(error, out, err) != 0;
    return CommandLineAnswer{.exit_status = fault ? 2 : 0,
                             .text = fault ? err.str() : out.str()};
  }
  if (invocation.name.empty() && invocation.options.input.empty()) {
    return CommandLineAnswer{.exit_status = 2, .text = app.help()};
  }
  return invocation;
}

}  // namespace tapfit::tui
