#include "updating/structure/cards/case_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tapfit::structure {
namespace {

bool has_card(const std::set<std::string>& cards, const char* beginning) {
  return std::ranges::any_of(cards, [&](const std::string& name) {
    return name.starts_with(beginning);
  });
}

void leave_out(const std::string& name,
               const CaseCommand& command,
               const std::string& consequence,
               CaseChanges& changes) {
  changes.left_out.push_back(
      {name,
       command.where,
       fmt::format("{} = {} of the case control is not supported: {}",
                   name,
                   command.value,
                   consequence)});
}

// Nastran adds them to dynamic responses alone.
void add_dynamic_matrix(const std::string& name,
                        const CaseCommand& command,
                        bool normal_modes,
                        CaseChanges& changes) {
  const bool stiffness = name.starts_with("K");
  if (!normal_modes) {
    leave_out(name,
              command,
              fmt::format("{} of responses is missing from the model; choose "
                          "the matrix by {} if it belongs to the structure",
                          stiffness ? "stiffness" : "mass",
                          stiffness ? "K2GG" : "M2GG"),
              changes);
    return;
  }
  changes.warnings.push_back(fmt::format(
      "{}: {} = {} is not in the model, for normal modes do not have it in "
      "Nastran either; choose the matrix by {} if it belongs to the structure",
      command.where,
      name,
      command.value,
      stiffness ? "K2GG" : "M2GG"));
}

bool is_of_materials(const CaseCommand& temperature) {
  const std::string& option = temperature.option;
  return option.empty() || option.starts_with("MAT") ||
         option.starts_with("BOTH");
}

}  // namespace

CaseChanges case_changes(const CaseControl& control,
                         const std::set<std::string>& cards) {
  CaseChanges changes;
  for (const auto& [name, command] : control.commands) {
    if (name == "STATSUB") {
      leave_out(name,
                command,
                "the stiffness of the preload is missing from the model",
                changes);
    } else if (name == "TEMPERATURE" && is_of_materials(command) &&
               has_card(cards, "MATT")) {
      leave_out(name,
                command,
                "the materials at that temperature (MATT) are missing from the "
                "model, which has those of the MAT cards; write the moduli at "
                "that temperature there",
                changes);
    } else if (name == "NSM" && !has_card(cards, "NSM")) {
      leave_out(name,
                command,
                "nonstructural mass is missing from the model; give it by the "
                "NSM of its properties",
                changes);
    } else if (name == "K2PP" || name == "M2PP") {
      add_dynamic_matrix(name, command, control.normal_modes, changes);
    } else if (name == "K42GG") {
      changes.warnings.push_back(fmt::format(
          "{}: K42GG = {} is structural damping, which enters nothing: each "
          "mode has a ratio of its own",
          command.where,
          command.value));
    }
  }
  return changes;
}

}  // namespace tapfit::structure
