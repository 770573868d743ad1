// An entry of bulk data, as the readers and writers of decks pass it on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::structure {

/// One bulk data entry. Field 0 is the name in capitals; continuation markers
/// (the tenth field of a line) are left out, so the fields of the second line
/// begin at 9.
struct Card {
  std::vector<std::string> fields;
  std::string where;  ///< "file:line" of its first line
  int line = 0;
  std::vector<std::size_t> lines;  ///< ascending, in BulkData::lines
  /// Written as a repetition of the one before; others may have its line.
  bool repeated = false;

  [[nodiscard]] const std::string& name() const { return fields.front(); }
};

}  // namespace tapfit::structure
