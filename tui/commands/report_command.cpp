#include "tui/commands/commands.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/library_versions.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/session_report.hpp"

#include <fmt/format.h>

namespace tapfit::tui {

std::string report_command(const CommandOptions& given,
                           const Progress& progress) {
  updating::Session session = open_as_kept(given, progress);
  CommandOptions options = given;
  if (!options.output) {
    options.output = session.bundle().folder / usual_report;
    check_outputs(session.bundle(), options);
  }
  ReportData data = report_data(session, options.input, progress);
  data.versions = library_versions();
  write_report(report_document(data),
               *options.output,
               output_rule(session.bundle(), options));
  return fmt::format("Report written to {}\n", options.output->string());
}

}  // namespace tapfit::tui
