// What a file of an edited deck is to hold, byte by byte.
#pragma once

#include "updating/structure/edit/file_places.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// An edited deck as files.
struct EditedLayout {
  DeckSource source;
  EditedDeck edited;
  std::vector<EditedFile> files;
  FilePlaces places;
};

/// Lines that are new end as the file's others do.
///
/// @param k in `files`
/// @return nothing where no INCLUDE line can name a file that is asked for
/// @throws InputError where the original is no longer what was edited
[[nodiscard]] std::optional<std::string> file_text(const EditedLayout& layout,
                                                   std::size_t k);

}  // namespace tapfit::structure
