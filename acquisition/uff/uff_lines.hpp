// The lines of one text dataset, read one after the other as numbers.
#pragma once

#include "acquisition/uff/uff_datasets.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Cut to an integer; 0 where that has no 32 bits to fit.
[[nodiscard]] int as_integer(double value);

class UffLines {
 public:
  /// @param dataset outlives this object
  explicit UffLines(const UffDataset& dataset) : dataset_(dataset) {}

  [[nodiscard]] bool done() const { return at_ >= dataset_.lines.size(); }
  /// Passes over blank lines at the end.
  [[nodiscard]] bool only_blanks_left() const;

  /// The next line as text, blanks at the ends taken off.
  /// @throws InputError where the dataset has no more lines
  std::string text();

  /// The numbers of the next line.
  /// @param width of a column, for numbers that touch
  /// @throws InputError for a line that is not there, holds something else or
  ///   a number that is not finite, or holds fewer than `least` numbers
  std::vector<double> numbers(std::size_t width, std::size_t least);

  /// A line of integers of 10 columns, then numbers of `width` columns.
  std::vector<double> mixed(std::size_t integers,
                            std::size_t width,
                            std::size_t count);

  /// `count` numbers from as many lines as they take.
  std::vector<double> many(std::size_t width, std::size_t count);

  /// As numbers(10, least), cut to integers.
  std::vector<int> integers(std::size_t least);
  std::vector<int> many_integers(std::size_t count);

 private:
  [[nodiscard]] std::string place() const;

  const UffDataset& dataset_;
  std::size_t at_ = 0;
};

}  // namespace tapfit::acquisition
