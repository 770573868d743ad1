// Columns of numbers out of a CSV file as data loggers write it.
#pragma once

#include "acquisition/foundation/progress.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct CsvOptions {
  /// Lines before the first row of numbers; empty: the file tells.
  std::optional<std::size_t> skip_lines;
};

/// A column of numbers, as lines above the first row of numbers tell of it.
struct CsvColumn {
  std::string number;  ///< from 1 on
  std::string name;    ///< empty: no line has one
  /// In a line of units, or behind the name: "a [g]"; s of times of day.
  std::string unit;
};

/// The columns whose field in the first row is a number or a time of day.
/// @throws InputError for a file without numbers
[[nodiscard]] std::vector<CsvColumn> list_csv_columns(
    const std::filesystem::path& file, const CsvOptions& options);

struct CsvTable {
  Eigen::MatrixXd values;          ///< n_rows x columns
  std::vector<std::string> units;  ///< per column; empty: none that is known
};

/// Reads some columns of a CSV file.
///
/// Separators are ; tab or , (found from the file); with ; or tab a comma may
/// be the decimal mark. Lines may end in CRLF, fields may be quoted, empty
/// lines at the end do not matter. Without skip_lines the numbers begin with
/// the first of two lines in a row whose first two fields are numbers, times of
/// day or dates. Times of day (clock_times.hpp) become seconds from the first
/// on.
///
/// @param columns each a name found in a header line, with or without the unit
///   behind it, in UTF-8 also where the file is in Latin-1, or a number from 1
///   on
/// @throws InputError with file:line:column for what is no finite number, for
///   a column that is not there, for a file without numbers; Stopped
[[nodiscard]] CsvTable read_csv_table(const std::filesystem::path& file,
                                      const std::vector<std::string>& columns,
                                      const CsvOptions& options,
                                      const Progress& progress = {});

/// Their values alone, n_rows x columns.size().
[[nodiscard]] Eigen::MatrixXd read_csv_columns(
    const std::filesystem::path& file,
    const std::vector<std::string>& columns,
    const CsvOptions& options);

/// Names of columns, and where they and the rows below them are.
struct CsvHeader {
  std::size_t line = 1;  ///< from 1 on
  std::vector<std::string> names;
  std::vector<std::string> units;  ///< of a line of units below; or empty
  std::size_t rows_from = 0;       ///< lines before the first row
  std::size_t rows = 0;            ///< lines from there on
};

/// The first line that is neither empty nor a comment (#, %, //), in UTF-8. A
/// line below it without any number is one of units.
/// @throws InputError for a file that cannot be opened or is empty
[[nodiscard]] CsvHeader read_csv_header(const std::filesystem::path& file);

}  // namespace tapfit::acquisition
