#include "updating/export/output_rule_of.hpp"

#include "updating/session/session_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating {

acquisition::OutputRule output_rule_of(const acquisition::TestBundle& bundle,
                                       bool force) {
  std::vector<std::filesystem::path> inputs{bundle.file, session_file(bundle)};
  for (const acquisition::Run& run : bundle.runs) inputs.push_back(run.file);
  if (bundle.frfs) inputs.push_back(*bundle.frfs);
  if (bundle.geometry) inputs.push_back(bundle.geometry->file);
  if (bundle.matrices) {
    const acquisition::MatrixModel& given = *bundle.matrices;
    inputs.insert(inputs.end(), {given.stiffness, given.mass, given.dofs});
  }
  if (bundle.deck) {
    for (std::filesystem::path& file : structure::deck_files(*bundle.deck)) {
      inputs.push_back(std::move(file));
    }
  }
  return {std::move(inputs), force};
}

}  // namespace tapfit::updating
