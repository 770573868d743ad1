// MATLAB files of version 4, byte by byte, for tests: per variable five
// 32-bit numbers (0 = little-endian doubles, rows, columns, no imaginary part,
// length of the name), the name, the numbers column by column.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace tapfit::testing {

inline std::string mat4_variable(const std::string& name,
                                 const Eigen::MatrixXd& values) {
  std::string bytes;
  const auto add = [&](std::size_t value) {
    const auto number = static_cast<std::int32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&number), 4);
  };
  add(0);
  add(static_cast<std::size_t>(values.rows()));
  add(static_cast<std::size_t>(values.cols()));
  add(0);
  add(name.size() + 1);
  bytes += name + '\0';
  bytes.append(reinterpret_cast<const char*>(values.data()),
               static_cast<std::size_t>(values.size()) * sizeof(double));
  return bytes;
}

}  // namespace tapfit::testing
