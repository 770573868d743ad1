// The room acquisition/uff. Universal files: taken apart into datasets, and the
// numbers, functions, shapes, points and units in these.
// In:  The bytes of a file.
// Out: Datasets as plain structs, in file units. What they mean to a test is
//      decided in acquisition/bundle and signal/files.
// May include: its row in CONTRIBUTING.md.
//
// A universal file taken apart into its datasets, and the numbers in them.
//
// A dataset stands between two lines of "    -1"; its first line is its type.
// In a binary function dataset (58b) that line also holds
// I6,A1,2I6,2I12: type, 'b', byte order (1 little, 2 big endian), float format
// (2 IEEE 754), number of text lines, number of bytes after them.
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::acquisition {

struct UffDataset {
  int type = 0;
  std::string place;  ///< "file, line 12", for messages
  /// After the type, line ends taken off; of a function only the header.
  std::vector<std::string_view> lines;
  bool binary = false;
  bool big_endian = false;
  /// A function's data: bytes, or text with its line ends.
  std::string_view data;
};

/// Header lines of a function (dataset 58).
inline constexpr std::size_t function_header_lines = 11;

/// Takes a file apart. The views point into `text`, which has to outlive them.
///
/// Lines outside of datasets are passed over; a last dataset without its
/// closing line is kept. Line ends may be LF, CR LF or both mixed.
///
/// @param name of the file, for messages
/// @param passed told of each part of the text that was looked through
/// @throws InputError for a dataset without a type, a binary one that is cut
///   off or in another float format than IEEE 754
[[nodiscard]] std::vector<UffDataset> split_uff(
    std::string_view text,
    const std::string& name,
    const std::function<void(std::string_view)>& passed = {});

/// The line that begins at `at`, its end taken off; `at` goes to the next one.
[[nodiscard]] std::string_view next_line(std::string_view text,
                                         std::size_t& at);

/// Columns [begin, begin + width) of a line, blanks at the ends taken off;
/// empty where the line is shorter.
[[nodiscard]] std::string_view column(std::string_view line,
                                      std::size_t begin,
                                      std::size_t width);

/// The whole text as one number; E, D and lost exponent letters (1.5-103) are
/// read, "nan" and "inf" become NaN. Empty text is no number.
[[nodiscard]] bool parse_number(std::string_view text, double& value);

/// As parse_number, cut to an integer; 0 for empty or unreadable text.
[[nodiscard]] int integer(std::string_view text);

/// All numbers of a data line: by blanks where that works, else by columns of
/// the given width (glued numbers), else sign by sign.
///
/// @param width of one number, 13 or 20
/// @return false when the line holds something else
[[nodiscard]] bool numbers(std::string_view line,
                           std::size_t width,
                           std::vector<double>& values);

}  // namespace tapfit::acquisition
