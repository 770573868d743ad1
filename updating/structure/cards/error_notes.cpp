#include "updating/structure/cards/error_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {

InputError with_notes(const InputError& error,
                      const std::vector<std::string>& notes) {
  if (notes.empty()) return error;
  constexpr std::size_t shown = 4;
  std::string text = error.remedy() + " It may come from: ";
  for (std::size_t i = 0; i < std::min(shown, notes.size()); ++i) {
    if (i > 0) text += "; ";
    text += notes[i];
  }
  if (notes.size() > shown) {
    text += fmt::format("; {} more notes", notes.size() - shown);
  }
  // Its text begins with the place and ends with the remedy.
  const std::string whole = error.what();
  const std::size_t begin = error.where().size() + 2;
  const std::size_t end = whole.size() - error.remedy().size() - 3;
  return {whole.substr(begin, end - begin), error.where(), text};
}

}  // namespace tapfit::structure
