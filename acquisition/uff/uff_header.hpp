// What every universal file that is written here begins with: datasets 151
// (header) and 164 (SI units); and parts of function datasets.
//
//   151   80A1 / 80A1 / 80A1 / 10A1,10A1,3I10 / 10A1,10A1 / 80A1 / 10A1,10A1
//   164   I10,20A1,I10 / 3D25.17 / D25.17
//   58    records 8-11: I10,3I5,2(1X,20A1)
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace tapfit::acquisition {

inline constexpr std::string_view uff_fence = "    -1\n";

struct TimeStamp {
  std::string date;   ///< DD-MMM-YY, months in English whatever the locale
  std::string clock;  ///< HH:MM:SS, universal time
};

[[nodiscard]] TimeStamp time_stamp();

/// One line of at most 80 characters of ASCII; "NONE" for an empty text.
[[nodiscard]] std::string uff_line(std::string text);

/// @param what the file holds, one line
void write_uff_header(const std::string& title,
                      std::string_view what,
                      std::ostream& out);

/// One axis of a function.
/// @param type specific data type: 13 force, 12 acceleration, 17 time, ...
void write_uff_axis(int type,
                    std::string_view name,
                    std::string_view unit,
                    std::ostream& out);

}  // namespace tapfit::acquisition
