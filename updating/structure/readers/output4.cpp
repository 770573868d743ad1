#include "updating/structure/readers/output4.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace tapfit::structure {
namespace {

constexpr int most_rows = 5'000'000;

struct Op4Head {
  int size = 0;
  int rows = 0;
  int type = 0;
  std::string name;
  std::size_t width = 16;  // of a number
};

// NCOL NROW NF NTYPE in eights, a name of eight, the format.
std::optional<Op4Head> parse_op4_head(const std::string& line) {
  if (line.size() < 40) return std::nullopt;
  std::array<int, 4> numbers{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto number = parse_integer(trimmed(line.substr(8 * k, 8)));
    if (!number) return std::nullopt;
    numbers.at(k) = *number;
  }
  Op4Head head;
  head.size = numbers[0];
  head.rows = std::abs(numbers[1]);  // below zero: long strings
  head.type = numbers[3];
  head.name = trimmed(upper(line.substr(32, 8)));
  const std::string format = upper(line.substr(40));
  if (const std::size_t at = format.find_first_of("ED");
      at != std::string::npos) {
    const int width = std::atoi(format.c_str() + at + 1);
    if (width > 5) head.width = static_cast<std::size_t>(width);
  }
  return head;
}

// The whole numbers of a line; nothing where any is none.
std::optional<std::vector<int>> whole_numbers(const std::string& line) {
  std::istringstream words(line);
  std::vector<int> numbers;
  for (std::string word; words >> word;) {
    const auto number = parse_integer(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

class Op4Reader {
 public:
  explicit Op4Reader(const std::filesystem::path& path)
      : file_(path), name_(path.filename().string()) {}

  // Of the next matrix; nothing at the end of the file.
  std::optional<Op4Head> head() {
    while (std::getline(file_, text_)) {
      ++line_;
      if (trimmed(text_).empty()) continue;
      const std::optional<Op4Head> head = parse_op4_head(text_);
      if (!head) fail("this is no head of a matrix");
      if (head->type > 2) fail("the matrix is complex");
      if (head->size < 1 || head->size > most_rows ||
          head->size != head->rows) {
        fail(fmt::format(
            "{} by {} is no square matrix", head->rows, head->size));
      }
      return head;
    }
    return std::nullopt;
  }

  SparseMatrix matrix(const Op4Head& head) {
    std::vector<Eigen::Triplet<double>> entries;
    int column = 0;
    int row = 0;
    while (column <= head.size && std::getline(file_, text_)) {
      ++line_;
      if (const auto whole = whole_numbers(text_)) {
        place(*whole, column, row);
        continue;
      }
      for (const double value : values(head.width)) {
        if (column > head.size) break;
        if (column < 1 || row < 1 || row > head.size) {
          fail(fmt::format("row {} of column {} is not there", row, column));
        }
        if (value != 0.0) entries.emplace_back(row - 1, column - 1, value);
        ++row;
      }
    }
    if (column <= head.size) fail("the matrix ends too soon");
    // A column beyond the last, with one number, ends it.
    if (std::getline(file_, text_)) ++line_;
    SparseMatrix A(head.size, head.size);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what,
                     fmt::format("{}:{}", name_, line_),
                     "Write real matrices by OUTPUT4 as text (FORMATTED), or "
                     "as Matrix Market files.");
  }

  // Where the numbers that follow go.
  void place(const std::vector<int>& whole, int& column, int& row) const {
    constexpr int length = 65536;
    switch (whole.size()) {
      case 0:
        return;
      case 1:  // a string: its length and first row in one number
        row = whole[0] % length;
        return;
      case 2:  // a long string
        row = whole[1];
        return;
      default:
        if (whole[0] <= column) fail("columns do not ascend");
        column = whole[0];
        row = whole[1];
    }
  }

  [[nodiscard]] std::vector<double> values(std::size_t width) const {
    std::vector<double> result;
    for (std::size_t at = 0; at < text_.size(); at += width) {
      const std::string word = trimmed(text_.substr(at, width));
      if (word.empty()) continue;
      const std::optional<double> value = parse_real(word);
      if (!value) fail("here is no finite number");
      result.push_back(*value);
    }
    return result;
  }

  std::ifstream file_;
  std::string name_;
  std::string text_;
  int line_ = 0;
};

}  // namespace

bool is_output4(const std::filesystem::path& path) {
  std::ifstream file = acquisition::open_input(path);
  // A head fills 80 columns at most; a foreign file's first line may not end.
  std::array<char, 128> line{};
  file.read(line.data(), line.size());
  const std::string_view begin(line.data(),
                               static_cast<std::size_t>(file.gcount()));
  return parse_op4_head(std::string(begin.substr(0, begin.find('\n'))))
      .has_value();
}

SparseMatrix read_output4(const std::filesystem::path& path, char letter) {
  Op4Reader reader(path);
  SparseMatrix only;
  std::vector<std::string> names;
  while (const std::optional<Op4Head> head = reader.head()) {
    SparseMatrix A = reader.matrix(*head);
    if (head->name.starts_with(letter)) return A;
    names.push_back(head->name);
    only = std::move(A);
  }
  if (names.size() == 1) return only;
  std::string all;
  for (const std::string& name : names) all += " " + name;
  throw InputError(
      fmt::format("no matrix of the file is called {}..., but{}", letter, all),
      path.filename().string(),
      "Write stiffness as K... and mass as M..., or each to a file.");
}

}  // namespace tapfit::structure
