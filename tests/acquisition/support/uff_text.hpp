// Functions of a universal file written column by column, for tests.
#pragma once

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <vector>

namespace tapfit::testing {

struct UffTestRecord {
  int function_type = 1;
  int node = 1;
  int direction = 3;
  int axis = 12;
  std::string unit = "m/s^2";
  double step = 1.0 / 1024.0;
  std::vector<double> values;
  std::string eol = "\n";
};

inline std::string uff_header(const UffTestRecord& r, int data_type) {
  std::string text = fmt::format("title{0}NONE{0}NONE{0}NONE{0}NONE{0}", r.eol);
  text += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}{}",
                      r.function_type,
                      1,
                      0,
                      0,
                      "NONE",
                      r.node,
                      r.direction,
                      "NONE",
                      0,
                      0,
                      r.eol);
  text += fmt::format("{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}{}",
                      data_type,
                      r.values.size(),
                      1,
                      0.0,
                      r.step,
                      0.0,
                      r.eol);
  const auto axis = [&](int type, const std::string& unit) {
    return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}{}",
                       type,
                       0,
                       0,
                       0,
                       "NONE",
                       unit,
                       r.eol);
  };
  return text + axis(17, "s") + axis(r.axis, r.unit) + axis(0, "NONE") +
         axis(0, "NONE");
}

/// Double precision text.
inline std::string uff_ascii(const UffTestRecord& r) {
  std::string text = "    -1" + r.eol + "    58" + r.eol + uff_header(r, 4);
  for (std::size_t i = 0; i < r.values.size(); ++i) {
    text += fmt::format("{:20.12E}", r.values[i]);
    if (i % 4 == 3 || i + 1 == r.values.size()) text += r.eol;
  }
  return text + "    -1" + r.eol;
}

/// Single precision, little endian, with a line end before the closing line.
inline std::string uff_binary(const UffTestRecord& r) {
  std::string text = "    -1" + r.eol;
  text += fmt::format("    58b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}{}",
                      1,
                      2,
                      11,
                      4 * r.values.size(),
                      0,
                      0,
                      0,
                      0,
                      r.eol);
  text += uff_header(r, 2);
  for (const double value : r.values) {
    const auto single = static_cast<float>(value);
    char bytes[4];
    std::memcpy(bytes, &single, 4);
    text.append(bytes, 4);
  }
  return text + r.eol + "    -1" + r.eol;
}

}  // namespace tapfit::testing
