#include "updating/structure/cards/case_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tapfit::structure {
namespace {

bool has_card(const BulkData& bulk, const char* beginning) {
  return std::ranges::any_of(bulk.cards, [&](const Card& card) {
    return card.name().starts_with(beginning);
  });
}

void leave_out(const std::string& name,
               const CaseCommand& command,
               const std::string& consequence,
               BulkData& bulk) {
  bulk.left_out.push_back(
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
                        BulkData& bulk) {
  const bool stiffness = name.starts_with("K");
  if (!bulk.control.normal_modes) {
    leave_out(name,
              command,
              fmt::format("{} of responses is missing from the model; choose "
                          "the matrix by {} if it belongs to the structure",
                          stiffness ? "stiffness" : "mass",
                          stiffness ? "K2GG" : "M2GG"),
              bulk);
    return;
  }
  bulk.warnings.push_back(fmt::format(
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

void add_case_changes(BulkData& bulk) {
  for (const auto& [name, command] : bulk.control.commands) {
    if (name == "STATSUB") {
      leave_out(name,
                command,
                "the stiffness of the preload is missing from the model",
                bulk);
    } else if (name == "TEMPERATURE" && is_of_materials(command) &&
               has_card(bulk, "MATT")) {
      leave_out(name,
                command,
                "the materials at that temperature (MATT) are missing from the "
                "model, which has those of the MAT cards; write the moduli at "
                "that temperature there",
                bulk);
    } else if (name == "NSM" && !has_card(bulk, "NSM")) {
      leave_out(name,
                command,
                "nonstructural mass is missing from the model; give it by the "
                "NSM of its properties",
                bulk);
    } else if (name == "K2PP" || name == "M2PP") {
      add_dynamic_matrix(name, command, bulk);
    } else if (name == "K42GG") {
      bulk.warnings.push_back(fmt::format(
          "{}: K42GG = {} is structural damping, which enters nothing: each "
          "mode has a ratio of its own",
          command.where,
          command.value));
    }
  }
}

}  // namespace tapfit::structure
