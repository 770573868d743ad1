#include "tui/commands/report_command.hpp"

#include "tui/commands/add_diagnosed.hpp"
#include "tui/commands/diagnose_command.hpp"
#include "tui/commands/frf_command.hpp"
#include "tui/commands/hits_command.hpp"
#include "tui/commands/modes_command.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/report/session_report.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>

#include <map>

namespace tapfit::tui {

namespace {

using PairOf = std::map<int, updating::ModePair>;

PairOf by_measured_mode(const updating::Comparison& comparison) {
  PairOf pairs;
  for (const auto& pair : comparison.pairs) pairs[pair.measured] = pair;
  return pairs;
}

std::string model_cells(const PairOf& pairs, int mode) {
  const auto found = pairs.find(mode);
  if (found == pairs.end()) return " - | - | - |";
  const updating::ModePair& pair = found->second;
  return fmt::format(" {:.3f} | {:+.2f} | {:.3f} |",
                     pair.model_hz,
                     pair.error_percent,
                     pair.mac);
}

std::string section(const std::string& title, const std::string& body) {
  return fmt::format("\n## {}\n\n```\n{}```\n", title, body);
}

std::string measurement_sections(updating::Session& session,
                                 const Progress& progress) {
  std::string text;
  if (!session.bundle().runs.empty()) {
    text +=
        section("Hits", hits_text(session.bundle(), session.hits(progress)));
  }
  text += section("FRFs", frf_text(session.frfs(progress)));
  return text + section("Modes", modes_text(session.modes(progress)));
}

std::string model_sections(updating::Session& session,
                           const Progress& progress) {
  const updating::Comparison before = session.base_comparison(progress);
  const updating::Diagnosis diagnosis = add_diagnosed(session, progress);
  return section("Diagnosis and error ladder", diagnosis_text(diagnosis)) +
         "\n## Modes before and after\n\n" +
         before_after_table(before, session.comparison(progress));
}

}  // namespace

std::string before_after_table(const updating::Comparison& before,
                               const updating::Comparison& after) {
  const PairOf old_pairs = by_measured_mode(before);
  const PairOf new_pairs = by_measured_mode(after);
  std::map<int, double> measured;
  for (const auto& [mode, pair] : old_pairs) measured[mode] = pair.measured_hz;
  for (const auto& [mode, pair] : new_pairs) measured[mode] = pair.measured_hz;

  std::string text =
      "| mode | measured Hz | before Hz | error % | MAC | after Hz | error % "
      "| MAC |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& [mode, hz] : measured) {
    text += fmt::format("| {} | {:.3f} |", mode + 1, hz) +
            model_cells(old_pairs, mode) + model_cells(new_pairs, mode) + "\n";
  }
  return text;
}

std::string report_command(const CommandOptions& options,
                           const Progress& progress) {
  updating::Session session = open_by_hand(options, progress);
  std::string text = fmt::format("# {}\n", session.bundle().title) +
                     measurement_sections(session, progress);
  text += session.has_model()
              ? model_sections(session, progress)
              : "\nThe bundle names no model: the work ends with the modes.\n";
  if (!options.output) return text;
  write_text_file(text, *options.output);
  return fmt::format("Report written to {}\n", options.output->string());
}

}  // namespace tapfit::tui
