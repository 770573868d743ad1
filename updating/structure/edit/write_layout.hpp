// An edited deck written as the files that it was read from. The deck itself is
// written anew; of the files that it includes those in which something changes,
// beside it, the others stay where they are. Bytes of lines that do not change
// are those of the original.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

struct WrittenLayout {
  std::vector<std::filesystem::path> files;  ///< the deck itself first
  /// Why nothing was written; else empty.
  std::string hindrance;
};

/// Writes all files or none. INCLUDE lines stay as they are where they lead
/// from the new deck to the right file, else they name it.
///
/// @param deck that was edited, bulk data or keywords; what comes behind all
///   stands at the end of the deck itself
/// @param target of the deck itself
/// @param rule for all files; what the deck includes is an input, too
/// @throws InputError for a deck that was changed since, where the rule does
///   not let the target be written, or something cannot be written
[[nodiscard]] WrittenLayout write_layout(const std::filesystem::path& deck,
                                         const EditedDeck& edited,
                                         const std::filesystem::path& target,
                                         acquisition::OutputRule rule);

}  // namespace tapfit::structure
