// The room tui/options. What commands can be told, and what they share: opening
// the bundle, decisions by hand, the line of progress.
// In:  The command line.
// Out: CommandOptions.
// May include: its row in CONTRIBUTING.md.
//
// What every command line command is given, and what it returns.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/poles/identify_options.hpp"
#include "updating/measurement/mode_choices.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// What `tapfit import` is told about the files.
struct ImportArguments {
  std::vector<std::string> files;  ///< "FILE" or "FILE@POINT"
  /// "COLUMN@POINT[,KEY=VALUE ...]"; empty: found in the file.
  std::string hammer;
  std::vector<std::string> sensors;  ///< the same; none: all others
  std::string rate;         ///< Hz, or the variable of a file that holds it
  std::string time_column;  ///< empty: the first of a CSV, or what a file says
  std::string title;
  std::optional<std::array<double, 2>> band_hz;
};

/// How FRFs are to be estimated and written.
struct FrfArguments {
  std::string estimator = "H1";      ///< H1, H2, Hv
  std::string form = "accelerance";  ///< accelerance, mobility, receptance
  std::optional<double> window;      ///< exponential's value at the block's end
  std::optional<double> sigma;       ///< on the line sigma + j omega [1/s]
  bool best_hits = false;            ///< without those that stand apart
};

/// What `tapfit paper` is told.
struct PaperArguments {
  std::vector<std::string> structures;  ///< "truss", "wing", "frame"; none: all
  /// Folder for the bundles' FRFs, made again.
  std::optional<std::filesystem::path> write;
};

/// What `tapfit modes` is told.
struct ModesArguments {
  modal::IdentifyOptions identify;
  bool diagram = false;                      ///< print it too
  std::optional<std::filesystem::path> fit;  ///< synthesised FRFs, UFF 58
  int dataset = 55;                          ///< of --uff: 55 or 2414
};

/// What `tapfit predict` is told; its --with are CommandOptions::effects.
struct PredictArguments {
  std::vector<std::string> changes;              ///< "added-mass@201=0.010"
  std::optional<std::filesystem::path> against;  ///< measured after the change
  /// From one set-up of a structure to the next, of frequencies (sd) [%].
  double repeatability_percent = 0.0;
};

/// What `tapfit together` is told; its --effect are CommandOptions::effects.
struct TogetherArguments {
  std::vector<std::filesystem::path> bundles;
  std::vector<std::string> shared;  ///< effects of one size in all tests
  /// "2", "added-mass@201", ...: the number of a test, its effect.
  std::vector<std::pair<int, std::string>> single;
  std::vector<std::string> own;  ///< "E:1": properties that are each test's own
  bool structures = false;       ///< the tests are of several structures
};

/// What a command is told of decisions made by hand.
struct HandChoices {
  bool session = false;            ///< start from those that are kept
  bool keep = false;               ///< and keep what was given with them
  updating::ModeChoices modes;     ///< without pairs
  std::vector<std::string> pairs;  ///< "2:3", measured and model, from 1
};

/// The command line of one command; each command reads what it knows of.
struct CommandOptions {
  std::filesystem::path input;  ///< bundle or deck; of paper: their folder
  bool json = false;            ///< one JSON object instead of text
  std::string csv;              ///< the table of it to print instead, if any
  bool force = false;           ///< replace files that are there
  bool inside = false;          ///< read nothing from outside the folder
  std::optional<std::filesystem::path> uff;      ///< universal file to write
  std::optional<std::filesystem::path> deck;     ///< bulk data to write
  std::optional<std::filesystem::path> output;   ///< file or folder to write
  std::optional<std::filesystem::path> records;  ///< time records to write
  std::optional<std::filesystem::path> vtu;      ///< shapes for ParaView
  std::optional<std::filesystem::path> plots;    ///< folder of all plots
  std::optional<std::filesystem::path> tables;   ///< folder of all tables
  bool text_records = false;                     ///< these not as binary
  int node_dataset = 2411;  ///< of these universal files: 15 or 2411
  std::optional<std::filesystem::path> saved;  ///< session to do again
  std::vector<std::string> effects;            ///< "added-mass@201", in order
  std::vector<std::string> free;               ///< "acc1=0.02", masses to free
  std::string lines = "damped";  ///< see updating/residual/line_rule.hpp
  std::string lambda;  ///< a number or "l-curve"; empty: not asked for
  int modes = 10;      ///< of the model
  std::vector<std::string> ignored_cards;  ///< of a deck, left out knowingly
  std::string units;        ///< of a deck; empty: the bundle's, or SI
  int node = 0;             ///< grid id
  double mass_kg = 0.0;     ///< of a free body; 0: not said
  bool robustness = false;  ///< how firm the verdict is, too
  double speed = 0.0;       ///< of a replay, times real time; 0: all it can
  FrfArguments frf;
  ImportArguments imports;
  PaperArguments paper;
  ModesArguments identification;
  HandChoices by_hand;
  std::optional<std::filesystem::path> other;  ///< second set of modes
  PredictArguments prediction;
  TogetherArguments together;
};

/// A command returns all of its standard output at once, so that a fault on
/// the way leaves nothing printed.
///
/// @throws InputError, Stopped
using Command = std::string (*)(const CommandOptions& options,
                                const Progress& progress);

}  // namespace tapfit::tui
