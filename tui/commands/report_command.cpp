#include "tui/commands/report_command.hpp"

#include "tui/options/hand_choices.hpp"
#include "tui/report/session_report.hpp"
#include "tui/work/session_file.hpp"

#include <fmt/format.h>

namespace tapfit::tui {

std::string report_command(const CommandOptions& options,
                           const Progress& progress) {
  updating::Session session = open_as_kept(options, progress);
  const std::filesystem::path path =
      options.output.value_or(usual_report(session_file(options.input)));
  write_report(report_document(report_data(session, options.input, progress)),
               path);
  return fmt::format("Report written to {}\n", path.string());
}

}  // namespace tapfit::tui
