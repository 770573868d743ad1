#include "updating/structure/readers/output4.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
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

constexpr std::size_t head_bytes = 24;

// The first record of a binary file, in either order of bytes: its length
// stands in front of it and behind it.
bool is_binary_head(std::string_view begin) {
  if (begin.size() < head_bytes + 8) return false;
  const std::string_view front = begin.substr(0, 4);
  const std::string zeros(3, '\0');
  const std::string length(1, static_cast<char>(head_bytes));
  return (front == length + zeros || front == zeros + length) &&
         begin.substr(head_bytes + 4, 4) == front;
}

// Records as Fortran writes them. A column is its number, first row (0: strings
// follow) and length in words of four bytes, then its numbers; a string has its
// length and first row in one word, or in two where the rows are below zero.
class BinaryOp4Reader {
 public:
  explicit BinaryOp4Reader(const std::filesystem::path& path)
      : file_(path, std::ios::binary),
        name_(path.filename().string()),
        left_(std::filesystem::file_size(path)) {
    const bool little = file_.peek() != 0;
    swap_ = little != (std::endian::native == std::endian::little);
  }

  std::optional<Op4Head> head() {
    if (left_ == 0) return std::nullopt;
    next_record();
    if (bytes_.size() != head_bytes) fail("this is no head of a matrix");
    Op4Head head;
    head.size = word(0);
    head.rows =
        word(1) == std::numeric_limits<int>::min() ? 0 : std::abs(word(1));
    long_ = word(1) < 0;
    head.type = word(3);
    head.name = trimmed(upper(bytes_.substr(16, 8)));
    if (head.type > 2) fail("the matrix is complex");
    if (head.size < 1 || head.size > most_rows || head.size != head.rows) {
      fail(fmt::format("{} by {} is no square matrix", head.rows, head.size));
    }
    return head;
  }

  SparseMatrix matrix(const Op4Head& head) {
    std::vector<Eigen::Triplet<double>> entries;
    while (true) {
      if (left_ == 0) fail("the matrix ends too soon");
      next_record();
      if (bytes_.size() < 12) fail("this is no column");
      const int column = word(0);
      if (column > head.size) break;
      std::size_t at = 3;
      if (word(1) != 0) {
        take(head, column, word(1), word(2), at, entries);
        continue;
      }
      while (at < bytes_.size() / 4) {
        const int first = word(at++);
        const int length = (long_ ? first : first / 65536) - 1;
        const int row = long_ ? word(at++) : first % 65536;
        take(head, column, row, length, at, entries);
      }
    }
    SparseMatrix A(head.size, head.size);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what,
                     name_,
                     "Write real matrices by OUTPUT4, with 4-byte integers, or "
                     "as text (FORMATTED), or as Matrix Market files.");
  }

  void next_record() {
    bytes_.assign(4, 0);
    file_.read(bytes_.data(), 4);
    const auto length = static_cast<std::uint32_t>(word(0));
    if (left_ < 8 || length > left_ - 8) fail("the file ends too soon");
    bytes_.assign(length, 0);
    file_.read(bytes_.data(), static_cast<std::streamsize>(length));
    file_.ignore(4);
    if (!file_) fail("the file ends too soon");
    left_ -= length + std::uintmax_t{8};
  }

  // Adds `words` words of numbers from `at` on.
  void take(const Op4Head& head,
            int column,
            int row,
            int words,
            std::size_t& at,
            std::vector<Eigen::Triplet<double>>& entries) const {
    const std::size_t per = head.type == 2 ? 2 : 1;
    const int count = words / static_cast<int>(per);
    if (column < 1 || row < 1 || count < 0 || row - 1 > head.size - count) {
      fail(fmt::format("row {} of column {} is not there", row, column));
    }
    for (int k = 0; k < count; ++k, at += per) {
      const double value = per == 2 ? number<double>(at) : number<float>(at);
      if (!std::isfinite(value)) fail("here is no finite number");
      if (value != 0.0) entries.emplace_back(row - 1 + k, column - 1, value);
    }
  }

  template <typename Number>
  [[nodiscard]] Number number(std::size_t at) const {
    if (4 * at + sizeof(Number) > bytes_.size()) fail("a column ends too soon");
    std::array<char, sizeof(Number)> raw{};
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(4 * at),
                raw.size(),
                raw.begin());
    if (swap_) std::ranges::reverse(raw);
    return std::bit_cast<Number>(raw);
  }

  [[nodiscard]] int word(std::size_t at) const {
    return number<std::int32_t>(at);
  }

  std::ifstream file_;
  std::string name_;
  std::uintmax_t left_ = 0;
  std::string bytes_;  // of the record
  bool swap_ = false;
  bool long_ = false;  // strings with two words in front
};

template <typename Reader>
SparseMatrix matrix_of(Reader reader,
                       const std::filesystem::path& path,
                       char letter) {
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

// A head fills 80 columns at most; a foreign file's first line may not end.
std::string beginning(const std::filesystem::path& path) {
  std::ifstream file = acquisition::open_input(path);
  std::string bytes(128, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace

bool is_output4(const std::filesystem::path& path) {
  const std::string begin = beginning(path);
  return is_binary_head(begin) ||
         parse_op4_head(begin.substr(0, begin.find('\n'))).has_value();
}

SparseMatrix read_output4(const std::filesystem::path& path, char letter) {
  if (is_binary_head(beginning(path))) {
    return matrix_of(BinaryOp4Reader(path), path, letter);
  }
  return matrix_of(Op4Reader(path), path, letter);
}

}  // namespace tapfit::structure
