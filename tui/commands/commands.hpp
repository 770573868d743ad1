// The commands, each in the file of its name: all of its standard output.
//
// Each throws InputError for input that it cannot work with (a bundle without a
// model where it needs one, a file that may not be written) and Stopped.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// Gain and delay of every sensor against the hammer, from blows on a body of
/// known mass.
[[nodiscard]] std::string calibrate_command(const CommandOptions& options,
                                            const Progress& progress);

/// What is wrong with a test, before any model: findings with their remedies;
/// below them what each channel recorded, coherence of sensors x hits, driving
/// points, reciprocity, lowest lines, H1 against H2 at the peaks.
[[nodiscard]] std::string check_command(const CommandOptions& options,
                                        const Progress& progress);

/// The base model against the measurement.
[[nodiscard]] std::string compare_command(const CommandOptions& options,
                                          const Progress& progress);

/// What is missing from the model.
[[nodiscard]] std::string diagnose_command(const CommandOptions& options,
                                           const Progress& progress);

/// Whether the program has what it needs where it runs.
[[nodiscard]] std::string doctor_command(const CommandOptions& options,
                                         const Progress& progress);

/// --uff writes the measured FRFs and modes (datasets 58 and 55), --records the
/// recordings (58b, or 58 with --text), both with the grids and lines of the
/// model where there is one (2411, or 15 with --nodes 15, and 82); --deck the
/// deck, in the style it came in, with the cards of the effects named by
/// --effect (without any: those that the diagnosis supports); --vtu the shapes
/// of the model with the effects named, and those measured.
[[nodiscard]] std::string export_command(const CommandOptions& options,
                                         const Progress& progress);

/// The measured FRFs and how good they are. With --uff also writes the curves,
/// in the form asked for; with --free the sensors' masses are taken off first.
[[nodiscard]] std::string frf_command(const CommandOptions& options,
                                      const Progress& progress);

/// The hits found in each run, and what is thought of each.
[[nodiscard]] std::string hits_command(const CommandOptions& options,
                                       const Progress& progress);

/// Makes a test bundle out of files of time records, and says what was assumed
/// of the channels that the command line does not name.
[[nodiscard]] std::string import_command(const CommandOptions& options,
                                         const Progress& progress);

/// Two sets of modes against each other, or one against itself.
[[nodiscard]] std::string mac_command(const CommandOptions& options,
                                      const Progress& progress);

/// What a deck (or the deck of a bundle) holds, and its modes.
[[nodiscard]] std::string model_command(const CommandOptions& options,
                                        const Progress& progress);

/// The modes identified with the options given. With --uff also writes them,
/// with --fit the synthesised FRFs, with --diagram prints the stabilisation
/// diagram.
[[nodiscard]] std::string modes_command(const CommandOptions& options,
                                        const Progress& progress);

/// What a known change will do to the structure, with intervals. With --uff
/// also writes the predicted FRFs; with --against says whether modes measured
/// after the change confirm it.
[[nodiscard]] std::string predict_command(const CommandOptions& options,
                                          const Progress& progress);

/// The test as if it were being measured: streams the recordings with bounded
/// memory; each hit is shown on standard error when its block is complete. The
/// FRFs as `tapfit frf` has them.
[[nodiscard]] std::string replay_command(const CommandOptions& options,
                                         const Progress& progress);

/// The finished work as one document. Takes up what was done in the terminal,
/// where anything was; where no effect was added there, runs the chain and adds
/// every rung of the diagnosis. Writes the report to --output, or to
/// report.html beside the bundle's session.json.
[[nodiscard]] std::string report_command(const CommandOptions& options,
                                         const Progress& progress);

/// The whole chain. Text ends with the error ladder; JSON is {"hits", "frf",
/// "modes", "compare", "diagnose"}. Without a model the last two are null and
/// the text ends with the modes.
[[nodiscard]] std::string run_command(const CommandOptions& options,
                                      const Progress& progress);

/// Does again, without a terminal, what was saved while a test was worked on,
/// and compares what comes out with what came out then.
[[nodiscard]] std::string session_command(const CommandOptions& options,
                                          const Progress& progress);

/// The missing dynamic stiffness z(s) at one grid, against frequency, and how
/// well mass, spring and dashpot explain it.
[[nodiscard]] std::string signature_command(const CommandOptions& options,
                                            const Progress& progress);

/// Header, units, points, trace lines, elements, functions and shapes of a
/// universal file, and which datasets are not known.
[[nodiscard]] std::string uff_command(const CommandOptions& options,
                                      const Progress& progress);

/// Adds the effects named, in order, and identifies them.
[[nodiscard]] std::string update_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
