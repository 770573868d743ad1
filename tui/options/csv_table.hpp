// A table of what a command prints as JSON, as comma separated values: numbers
// with all their digits, columns by the names of the fields.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <string>
#include <string_view>

namespace tapfit::tui {

/// The command line names a table that its command does not print.
class NoSuchTable : public InputError {
 public:
  using InputError::InputError;
};

/// The array or object of that name, a row per entry. Fields of fields have
/// columns such as "frequency_hz.sd"; of an object the first column is "name".
/// Lists within a field become one cell, their entries apart by blanks
/// (numbers) or "; " (words); null is an empty cell.
///
/// @param json one JSON object as text
/// @param table "pairs"; "runs.hits" for the hits of all runs, with the fields
///   of their run before them
/// @return empty for a table without entries
/// @throws NoSuchTable naming those there are
[[nodiscard]] std::string csv_table(std::string_view json,
                                    std::string_view table);

}  // namespace tapfit::tui
