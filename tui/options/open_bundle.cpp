#include "tui/options/open_bundle.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/options/standard_streams.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/export/outside_files.hpp"
#include "updating/export/report_files.hpp"
#include "updating/export/shapes_vtu.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapfit::tui {
namespace {

// All files that the command is to write.
std::vector<std::filesystem::path> outputs_of(const CommandOptions& options) {
  std::vector<std::filesystem::path> outputs;
  for (const auto& output : {options.uff,
                             options.deck,
                             options.output,
                             options.records,
                             options.identification.fit}) {
    if (output) outputs.push_back(*output);
  }
  if (options.vtu) {
    const auto files = updating::vtu_files(*options.vtu);
    outputs.insert(outputs.end(), files.begin(), files.end());
  }
  return outputs;
}

}  // namespace

std::vector<std::string> input_warnings(updating::Session& session) {
  std::vector<std::string> warnings = session.bundle().warnings;
  if (session.bundle().deck) {
    const std::vector<std::string>& deck = session.deck().warnings;
    warnings.insert(warnings.end(), deck.begin(), deck.end());
  }
  return warnings;
}

updating::Diagnosis with_input_warnings(updating::Diagnosis diagnosis,
                                        updating::Session& session) {
  const std::vector<std::string> more = input_warnings(session);
  diagnosis.warnings.insert(diagnosis.warnings.end(), more.begin(), more.end());
  return diagnosis;
}

updating::Session open_bundle(const std::filesystem::path& bundle) {
  updating::Session session(bundle);
  for (const std::string& warning : input_warnings(session)) {
    say(fmt::format("note: {}\n", warning));
  }
  std::vector<std::string> outside;
  for (const auto& file : updating::outside_files(session.bundle())) {
    outside.push_back(file.string());
  }
  if (!outside.empty()) {
    say(fmt::format("note: the test reads from outside its folder: {}\n",
                    fmt::join(outside, ", ")));
  }
  return session;
}

void refuse_modes(const acquisition::TestBundle& bundle) {
  if (!bundle.modes) return;
  throw InputError("the test consists of modes: it has no FRFs",
                   bundle.file.string(),
                   "for FRFs give \"runs\" or \"frfs\"; modes are compared "
                   "and diagnosed as they are");
}

acquisition::OutputRule output_rule(const acquisition::TestBundle& bundle,
                                    const CommandOptions& options) {
  acquisition::OutputRule rule =
      updating::output_rule_of(bundle, options.force, outputs_of(options));
  if (options.saved) rule.inputs.push_back(*options.saved);
  return rule;
}

void check_outputs(const acquisition::TestBundle& bundle,
                   const CommandOptions& options) {
  const std::vector<std::filesystem::path> outputs = outputs_of(options);
  if (outputs.empty()) return;
  const acquisition::OutputRule rule = output_rule(bundle, options);
  rule.check(outputs);
  if (options.output) updating::check_report(rule, *options.output);
}

updating::Session open_bundle(const CommandOptions& options) {
  updating::Session session = open_bundle(options.input);
  check_outputs(session.bundle(), options);
  return session;
}

}  // namespace tapfit::tui
