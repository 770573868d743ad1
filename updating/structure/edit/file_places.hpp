// Where the files of an edited deck come to stand: what does not change stays,
// what does is written beside the new deck.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "updating/structure/edit/edited_files.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <vector>

namespace tapfit::structure {

struct FilePlaces {
  /// One for each file; the original's own for one that is not written.
  std::vector<std::filesystem::path> at;
  std::vector<bool> written;
  /// Folder of the new deck.
  std::filesystem::path folder;

  /// Whether a file is there, or will be.
  [[nodiscard]] bool has(const std::filesystem::path& file) const;
  /// Whether an INCLUDE of that name leads there.
  /// @param asks in which file it stands, in `at`
  [[nodiscard]] bool leads(std::size_t asks,
                           const std::string& name,
                           std::size_t to) const;
};

/// Files with changes are written, and those that lead to one of them or would
/// not find from the new deck what they ask for. A file keeps its path from the
/// deck's folder where that is free, or is part of the deck that is replaced;
/// else its name has the new deck's in front. Nothing that is there besides is
/// written over.
///
/// @param files as of edited_files()
/// @param target of the deck itself
/// @param rule whose inputs are left alone, and whether the deck at `target`
///   may be replaced
[[nodiscard]] FilePlaces file_places(const std::vector<EditedFile>& files,
                                     const std::filesystem::path& target,
                                     const acquisition::OutputRule& rule);

}  // namespace tapfit::structure
