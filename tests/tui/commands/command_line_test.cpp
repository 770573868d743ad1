#include "tui/commands/command_line.hpp"

#include "tests/tui/support/holds.hpp"
#include "tui/commands/commands.hpp"
#include "tui/commands/update_command.hpp"
#include "tui/options/help_format.hpp"
#include "tui/paper/paper_command.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace tapfit::tui {
namespace {

std::variant<Invocation, CommandLineAnswer> parse(
    std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "tapfit");
  return parse_command_line(static_cast<int>(arguments.size()),
                            arguments.data());
}

Invocation parsed(const std::vector<const char*>& arguments) {
  auto result = parse(arguments);
  if (const auto* answer = std::get_if<CommandLineAnswer>(&result)) {
    ADD_FAILURE() << answer->text;
    return {};
  }
  return std::get<Invocation>(result);
}

CommandLineAnswer answered(const std::vector<const char*>& arguments) {
  auto result = parse(arguments);
  if (std::holds_alternative<Invocation>(result)) {
    ADD_FAILURE() << "was taken for a command";
    return {};
  }
  return std::get<CommandLineAnswer>(result);
}

TEST(CommandLine, BundleAloneOpensTheTerminal) {
  const Invocation invocation = parsed({"some/bundle", "--ascii"});
  EXPECT_EQ(invocation.command, nullptr);
  EXPECT_EQ(invocation.name, "");
  EXPECT_EQ(invocation.options.input, "some/bundle");
  EXPECT_TRUE(invocation.app.ascii);
  EXPECT_FALSE(invocation.app.keys_file.has_value());
}

TEST(CommandLine, TourIsTheTerminalWithWords) {
  const Invocation alone = parsed({"tour"});
  EXPECT_EQ(alone.command, nullptr);
  EXPECT_TRUE(alone.app.tour);
  EXPECT_TRUE(alone.options.input.empty());
  const Invocation named = parsed({"tour", "some/bundle", "--ascii"});
  EXPECT_EQ(named.options.input, "some/bundle");
  EXPECT_TRUE(named.app.ascii);
  EXPECT_FALSE(parsed({"some/bundle"}).app.tour);
}

TEST(CommandLine, CommandTakesBundleAndJson) {
  const Invocation invocation = parsed({"run", "some/bundle", "--json"});
  EXPECT_EQ(invocation.command, &run_command);
  EXPECT_EQ(invocation.options.input, "some/bundle");
  EXPECT_TRUE(invocation.options.json);
}

TEST(CommandLine, TakesWhatIsDecidedByHandAboutModes) {
  const HandChoices told = parsed({"compare",
                                   "some/bundle",
                                   "--drop",
                                   "12.98",
                                   "--add",
                                   "20",
                                   "--drop",
                                   "31",
                                   "--band",
                                   "5",
                                   "60",
                                   "--pair",
                                   "2:3",
                                   "--pair",
                                   "4:none",
                                   "--session",
                                   "--keep"})
                               .options.by_hand;
  using What = modal::PoleEdit::What;
  const std::vector<modal::PoleEdit> edits{
      {What::Drop, 12.98}, {What::Drop, 31.0}, {What::Add, 20.0}};
  EXPECT_EQ(told.modes.edits, edits);
  EXPECT_EQ(told.modes.band_hz, (std::array<double, 2>{5.0, 60.0}));
  EXPECT_EQ(told.pairs, (std::vector<std::string>{"2:3", "4:none"}));
  EXPECT_TRUE(told.session);
  EXPECT_TRUE(told.keep);
  EXPECT_EQ(answered({"compare", "b", "--pair", "2-3"}).exit_status, 2);
  EXPECT_EQ(answered({"modes", "b", "--drop", "-1"}).exit_status, 2);
}

TEST(CommandLine, UpdateTakesLinesAndLambda) {
  const Invocation invocation = parsed(
      {"update", "some/bundle", "--lines", "rule:2", "--lambda", "l-curve"});
  const updating::UpdateChoice choice = update_choice(invocation.options);
  EXPECT_EQ(choice.lines.kind, updating::LineKind::Rule);
  EXPECT_TRUE(choice.l_curve);
  EXPECT_FALSE(choice.lambda);
  const Invocation fixed = parsed({"update", "b", "--lambda", "0.02"});
  EXPECT_EQ(update_choice(fixed.options).lambda, 0.02);
  EXPECT_FALSE(update_choice(parsed({"update", "b"}).options).is_plain());
  for (const char* lambda : {"-1", "nan", "corner", "1x", ""}) {
    EXPECT_EQ(answered({"update", "b", "--lambda", lambda}).exit_status, 2)
        << lambda;
  }
  EXPECT_EQ(answered({"update", "b", "--lines", "peaks"}).exit_status, 2);
}

TEST(CommandLine, EffectsKeepTheirOrder) {
  const Invocation invocation = parsed({"update",
                                        "--effect",
                                        "added-mass@201",
                                        "some/bundle",
                                        "--effect",
                                        "sensor-mass"});
  EXPECT_EQ(invocation.command, &update_command);
  EXPECT_EQ(invocation.options.input, "some/bundle");
  EXPECT_EQ(invocation.options.effects,
            (std::vector<std::string>{"added-mass@201", "sensor-mass"}));
}

TEST(CommandLine, PredictTakesChangesWithTheirSizes) {
  const Invocation invocation = parsed({"predict",
                                        "some/bundle",
                                        "--effect",
                                        "added-mass@201=10g",
                                        "--effect",
                                        "dashpot@17=2",
                                        "--with",
                                        "sensor-mass",
                                        "--against",
                                        "other/bundle"});
  EXPECT_EQ(invocation.command, &predict_command);
  EXPECT_EQ(invocation.options.input, "some/bundle");
  EXPECT_EQ(invocation.options.prediction.changes,
            (std::vector<std::string>{"added-mass@201=10g", "dashpot@17=2"}));
  EXPECT_EQ(invocation.options.effects,
            (std::vector<std::string>{"sensor-mass"}));
  EXPECT_EQ(invocation.options.prediction.against, "other/bundle");
  EXPECT_EQ(
      parsed({"predict", "b", "--effect", "added-mass@2=1", "--with", "none"})
          .options.effects,
      (std::vector<std::string>{"none"}));
  EXPECT_EQ(answered({"predict", "b"}).exit_status, 2);
  EXPECT_EQ(answered({"predict",
                      "b",
                      "--effect",
                      "added-mass@2=1",
                      "--repeatability",
                      "0.1"})
                .exit_status,
            2)
      << "says nothing without --against";
  const CommandLineAnswer unsized =
      answered({"predict", "b", "--effect", "added-mass@201"});
  EXPECT_EQ(unsized.exit_status, 2);
  EXPECT_NE(unsized.text.find("no size is stated"), std::string::npos)
      << unsized.text;
  for (const char* change : {"added-mass@201=x",
                             "added-mas@201=1",
                             "channel-gain@acc1=1.1",
                             "added-mass@=1"}) {
    EXPECT_EQ(answered({"predict", "b", "--effect", change}).exit_status, 2)
        << change;
  }
}

TEST(CommandLine, PaperTakesStructuresAndAFolder) {
  const Invocation all = parsed({"paper"});
  EXPECT_EQ(all.command, &paper_command);
  EXPECT_EQ(all.options.input, "recordings");
  EXPECT_TRUE(all.options.paper.structures.empty());
  const Invocation two =
      parsed({"paper", "truss", "wing", "--recordings", "elsewhere"});
  EXPECT_EQ(two.options.input, "elsewhere");
  EXPECT_EQ(two.options.paper.structures,
            (std::vector<std::string>{"truss", "wing"}));
  EXPECT_EQ(answered({"paper", "bridge"}).exit_status, 2);
}

// As its help shows it, and as shells make it easy.
TEST(CommandLine, ImportTakesTheBandWithAndWithoutAComma) {
  const std::vector<const char*> some = {
      "import", "a.csv", "-o", "out", "--hammer", "2@1Z+", "--sensor", "3@1Z+"};
  std::vector<const char*> comma = some;
  comma.insert(comma.end(), {"--band", "8,100"});
  std::vector<const char*> blank = some;
  blank.insert(blank.end(), {"--band", "8", "100"});
  const std::array<double, 2> band = {8.0, 100.0};
  EXPECT_EQ(parsed(comma).options.imports.band_hz, band);
  EXPECT_EQ(parsed(blank).options.imports.band_hz, band);
  EXPECT_EQ(
      parsed({"modes", "b", "--band", "8,100"}).options.by_hand.modes.band_hz,
      band);
}

TEST(CommandLine, SimulateGetsItsArgumentsUntouched) {
  const Invocation invocation =
      parsed({"simulate", "out", "--seed", "7", "--help"});
  EXPECT_EQ(invocation.name, "simulate");
  EXPECT_EQ(invocation.passed_on,
            (std::vector<std::string>{"out", "--seed", "7", "--help"}));
}

TEST(CommandLine, CsvIsATableOfTheJson) {
  const Invocation hits = parsed({"hits", "--csv", "some/bundle"});
  EXPECT_EQ(hits.options.csv, "runs.hits");
  EXPECT_TRUE(hits.options.json);
  EXPECT_EQ(hits.options.input, "some/bundle");
  EXPECT_EQ(parsed({"compare", "b", "--csv=bands"}).options.csv, "bands");
  EXPECT_EQ(parsed({"compare", "b"}).options.csv, "");
  EXPECT_EQ(answered({"compare", "b", "--csv", "--json"}).exit_status, 2);
  for (const char* command :
       {"hits", "frf", "modes", "mac", "compare", "diagnose"}) {
    EXPECT_NE(parsed({command, "b", "--csv"}).options.csv, "") << command;
  }
}

TEST(CommandLine, SaysWhatWasMeant) {
  const auto says = [](const std::vector<const char*>& arguments,
                       const std::string& words) {
    const CommandLineAnswer answer = answered(arguments);
    EXPECT_EQ(answer.exit_status, 2);
    EXPECT_NE(answer.text.find(words), std::string::npos) << answer.text;
  };
  says({"diagnos"}, "neither a bundle nor a command \"diagnos\"");
  says({"diagnos"}, "Did you mean tapfit diagnose?");
  says({"diagnos", "some/bundle"}, "Did you mean tapfit diagnose?");
  says({"hits", "some/bundle", "--jsn"}, "Did you mean --json?");
  says({"--ligt", "b"}, "Did you mean --light?");
  says({"update", "b", "--effect", "sensor-mas"}, "did you mean sensor-mass?");
  EXPECT_EQ(answered({"run", "b", "--quux"}).text.find("mean"),
            std::string::npos);
  // A bundle whose name is like a command's is opened.
  EXPECT_EQ(parsed({TAPFIT_SOURCE_DIR "/modal"}).name, "");
}

TEST(CommandLine, HelpIsAWordToo) {
  EXPECT_EQ(answered({"help"}).text, answered({"--help"}).text);
  EXPECT_EQ(answered({"help", "modes"}).text,
            answered({"modes", "--help"}).text);
  EXPECT_EQ(answered({"help"}).exit_status, 0);
}

// A bundle is picked where there is a terminal; else this is printed.
TEST(CommandLine, NothingNamedComesWithTheHelp) {
  EXPECT_EQ(parsed({}).help, answered({"--help"}).text);
  EXPECT_EQ(parsed({"--ascii"}).app.ascii, true);
  EXPECT_EQ(parsed({"some/bundle"}).help, "");
  EXPECT_EQ(answered({"--keys", "script"}).exit_status, 2);
}

TEST(CommandLine, TheVersionNamesLibraries) {
  const std::string text = answered({"--version"}).text;
  for (const char* library : {"tapfit ",
                              "Eigen 3.",
                              "FFTW 3.",
                              "CHOLMOD ",
                              "libsndfile 1.",
                              "ncurses 6."}) {
    EXPECT_NE(text.find(library), std::string::npos) << text;
  }
}

TEST(CommandLine, HelpSetsStudiesApart) {
  const std::string text = answered({"--help"}).text;
  const std::size_t studies = text.find("Studies and practice:");
  ASSERT_NE(studies, std::string::npos) << text;
  for (const char* daily : {"run", "report", "import", "tour", "doctor"}) {
    EXPECT_LT(text.find(std::string("\n  ") + daily), studies) << daily;
  }
  for (const char* study :
       {"paper", "simulate", "challenge", "reveal", "score"}) {
    const std::size_t at = text.find(std::string("\n  ") + study);
    EXPECT_GT(at, studies) << study;
    EXPECT_NE(at, std::string::npos) << study;
  }
}

TEST(CommandLine, HelpIsInPlainWords) {
  for (const std::string& name : command_names()) {
    if (name == "simulate" || name == "challenge" || name == "score") continue;
    const std::string text = answered({name.c_str(), "--help"}).text;
    for (const char* jargon : {"TEXT:",
                               "FLOAT",
                               " INT",
                               " x 2",
                               "REQUIRED",
                               "Excludes",
                               "Needs",
                               "99999999",
                               "again for"}) {
      EXPECT_FALSE(holds(text, jargon)) << name << " " << jargon << "\n"
                                        << text;
    }
    if (name == "doctor") continue;
    EXPECT_TRUE(holds(text, "Example:\n  tapfit " + name)) << text;
  }
  const std::string report = answered({"report", "--help"}).text;
  EXPECT_TRUE(holds(report, "Folder of a test")) << report;
  EXPECT_TRUE(holds(report, "--band LOW HIGH")) << report;
  EXPECT_TRUE(holds(report, "(BUNDLE/report.html)")) << report;
  EXPECT_TRUE(holds(answered({"frf", "--help"}).text, "--estimator H1|H2|Hv"));
}

// They are known to be command lines only.
TEST(CommandLine, ExamplesOfTheHelpCanBeRead) {
  for (const std::string& name : command_names()) {
    const std::string text = example_of(name);
    if (text.empty()) continue;
    std::istringstream words(text.substr(text.find("tapfit")));
    std::vector<std::string> arguments{
        std::istream_iterator<std::string>(words), {}};
    std::vector<const char*> pointers;
    for (std::size_t k = 1; k < arguments.size(); ++k) {
      pointers.push_back(arguments[k].c_str());
    }
    EXPECT_EQ(parsed(pointers).name, name) << text;
  }
}

TEST(CommandLine, HelpAndVersionAreAnswersNotFaults) {
  EXPECT_EQ(answered({"--help"}).exit_status, 0);
  EXPECT_NE(answered({"--help"}).text.find("diagnose"), std::string::npos);
  EXPECT_EQ(answered({"--version"}).exit_status, 0);
  EXPECT_TRUE(answered({"--version"}).text.starts_with("tapfit "));
  EXPECT_EQ(answered({"hits", "--help"}).exit_status, 0);
}

TEST(CommandLine, FaultsAreStatusTwo) {
  EXPECT_EQ(answered({"run"}).exit_status, 2);
  const CommandLineAnswer nothing = answered({"export", "b"});
  EXPECT_EQ(nothing.exit_status, 2);
  EXPECT_NE(nothing.text.find("--vtu"), std::string::npos) << nothing.text;
  EXPECT_EQ(answered({"run", "b", "--no-such-option"}).exit_status, 2);
  EXPECT_EQ(answered({"run", "b", "c"}).exit_status, 2);
  EXPECT_EQ(answered({"model", "deck", "--modes", "0"}).exit_status, 2);
  EXPECT_EQ(answered({"signature", "b", "twelve"}).exit_status, 2);
  EXPECT_EQ(answered({"modes", "b", "--mpc", "nan"}).exit_status, 2);
  EXPECT_EQ(answered({"modes", "b", "--damping", "5", "1"}).exit_status, 2);
  EXPECT_EQ(answered({"modes", "b", "--band", "60", "50"}).exit_status, 2);
  EXPECT_EQ(answered({"modes", "b", "--band", "nan", "50"}).exit_status, 2);
}

TEST(CommandLine, SaysInPlainWordsWhatIsWrong) {
  const auto said = [](const std::vector<const char*>& arguments) {
    return answered(arguments).text;
  };
  EXPECT_TRUE(holds(said({"modes", "b", "--band", "3"}),
                    "--band takes 2 values, 1 was given"))
      << said({"modes", "b", "--band", "3"});
  EXPECT_TRUE(holds(said({"update", "b", "--lambda"}),
                    "--lambda takes a value: VALUE|l-curve"))
      << said({"update", "b", "--lambda"});
  EXPECT_TRUE(holds(said({"update", "b", "--effect", "foo@1"}),
                    "--effect: there is no effect \"foo\""))
      << said({"update", "b", "--effect", "foo@1"});
  EXPECT_TRUE(holds(said({"modes", "b", "--drop", "x"}),
                    "\"x\" is not a number from 0 on"))
      << said({"modes", "b", "--drop", "x"});
}

TEST(CommandLine, EveryCommandIsDescribed) {
  std::ifstream file(TAPFIT_SOURCE_DIR "/docs/commands.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& name : command_names()) {
    EXPECT_NE(page.find("tapfit " + name), std::string::npos)
        << "docs/commands.md does not describe tapfit " << name;
  }
}

}  // namespace
}  // namespace tapfit::tui
