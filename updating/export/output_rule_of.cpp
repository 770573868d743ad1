#include "updating/export/output_rule_of.hpp"

#include "updating/session/session_file.hpp"

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

acquisition::OutputRule output_rule_of(const acquisition::TestBundle& bundle,
                                       bool force) {
  return {inputs_of(bundle), force};
}

}  // namespace tapfit::updating
