#include "updating/export/output_rule_of.hpp"

#include "updating/export/output_rule_of_folder.hpp"
#include "updating/session/session_file.hpp"

#include <set>

namespace tapfit::updating {

std::vector<std::filesystem::path> inputs_of(
    const acquisition::TestBundle& bundle, const structure::MayOpen& may_open) {
  std::vector<std::filesystem::path> inputs{bundle.file, session_file(bundle)};
  for (const acquisition::Run& run : bundle.runs) inputs.push_back(run.file);
  if (bundle.frfs) inputs.push_back(*bundle.frfs);
  if (bundle.modes) inputs.push_back(bundle.modes->file);
  if (bundle.geometry) inputs.push_back(bundle.geometry->file);
  if (bundle.matrices) {
    const acquisition::MatrixModel& given = *bundle.matrices;
    inputs.insert(inputs.end(), {given.stiffness, given.mass, given.dofs});
  }
  if (bundle.deck) {
    for (std::filesystem::path& file :
         structure::deck_files(*bundle.deck, may_open)) {
      inputs.push_back(std::move(file));
    }
  }
  return inputs;
}

acquisition::OutputRule output_rule_of(
    const acquisition::TestBundle& bundle,
    bool force,
    const std::vector<std::filesystem::path>& outputs) {
  acquisition::OutputRule rule{inputs_of(bundle), force};
  std::set<std::filesystem::path> folders{bundle.folder};
  for (const auto& output : outputs) folders.insert(output.parent_path());
  for (const std::filesystem::path& folder : folders) {
    const acquisition::OutputRule beside =
        output_rule_of_folder(folder.empty() ? "." : folder, force);
    rule.inputs.insert(
        rule.inputs.end(), beside.inputs.begin(), beside.inputs.end());
  }
  return rule;
}

}  // namespace tapfit::updating
