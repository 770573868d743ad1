#include "tui/commands/report_command.hpp"

#include "tui/commands/diagnose_command.hpp"
#include "tui/commands/frf_command.hpp"
#include "tui/commands/hits_command.hpp"
#include "tui/commands/modes_command.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/report/before_after.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/hits_text.hpp"
#include "tui/report/modes_text.hpp"
#include "tui/report/session_report.hpp"
#include "updating/session/add_diagnosed.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>

namespace tapfit::tui {

namespace {

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
  const updating::Diagnosis diagnosis =
      updating::add_diagnosed(session, progress);
  return section("Diagnosis and error ladder", diagnosis_text(diagnosis)) +
         "\n## Modes before and after\n\n" +
         before_after_table(before, session.comparison(progress));
}

}  // namespace

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
