// Matrices of any program, on their way through Matrix Market files.
#pragma once

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <fmt/format.h>

#include <string>

namespace tapfit::structure {

/// The text of a symmetric matrix's file, with every digit.
inline std::string matrix_market(const Eigen::MatrixXd& A) {
  std::string entries;
  int count = 0;
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0.0) continue;
      entries += fmt::format("{} {} {}\n", i + 1, j + 1, A(i, j));
      ++count;
    }
  }
  return fmt::format(
      "%%MatrixMarket matrix coordinate real symmetric\n{} {} {}\n{}",
      A.rows(),
      A.cols(),
      count,
      entries);
}

}  // namespace tapfit::structure
