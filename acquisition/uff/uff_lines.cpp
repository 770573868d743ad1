#include "acquisition/uff/uff_lines.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

std::vector<int> as_integers(const std::vector<double>& values) {
  std::vector<int> result;
  for (const double value : values) {
    result.push_back(as_integer(value));
  }
  return result;
}

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values,
                             [](double value) { return std::isfinite(value); });
}

}  // namespace

int as_integer(double value) {
  return std::abs(value) < 2e9 ? static_cast<int>(value) : 0;
}

bool UffLines::only_blanks_left() const {
  return std::all_of(
      dataset_.lines.begin() + static_cast<std::ptrdiff_t>(at_),
      dataset_.lines.end(),
      [](std::string_view line) { return column(line, 0, 80).empty(); });
}

std::string UffLines::place() const {
  return fmt::format(
      "{}, line {} of dataset {}", dataset_.place, at_, dataset_.type);
}

std::string UffLines::text() {
  if (done()) {
    throw InputError("the dataset ends within an entry",
                     place(),
                     "the file is cut off; export it anew");
  }
  return printable(column(dataset_.lines[at_++], 0, std::string::npos));
}

std::vector<double> UffLines::numbers(std::size_t width, std::size_t least) {
  const std::string line = text();
  std::vector<double> values;
  const bool good =
      acquisition::numbers(dataset_.lines[at_ - 1], width, values) &&
      all_finite(values);
  if (!good || values.size() < least) {
    throw InputError(fmt::format("\"{}\" holds {} where {} numbers belong",
                                 line,
                                 good ? fmt::format("{}", values.size())
                                      : "other than finite numbers",
                                 least),
                     place(),
                     "correct the line, or export the file anew");
  }
  return values;
}

std::vector<double> UffLines::mixed(std::size_t integers,
                                    std::size_t width,
                                    std::size_t count) {
  // By columns where that gives them all: an integer may touch what follows.
  if (!done()) {
    const std::string_view line = dataset_.lines[at_];
    const std::size_t lead = std::min(10 * integers, line.size());
    std::vector<double> values;
    if (acquisition::numbers(line.substr(0, lead), 10, values) &&
        values.size() == integers &&
        acquisition::numbers(line.substr(lead), width, values) &&
        values.size() == integers + count && all_finite(values)) {
      ++at_;
      return values;
    }
  }
  return numbers(width, integers + count);
}

std::vector<double> UffLines::many(std::size_t width, std::size_t count) {
  std::vector<double> values;
  while (values.size() < count) {
    const std::vector<double> line = numbers(width, 1);
    values.insert(values.end(), line.begin(), line.end());
  }
  values.resize(count);
  return values;
}

std::vector<int> UffLines::integers(std::size_t least) {
  return as_integers(numbers(10, least));
}

std::vector<int> UffLines::many_integers(std::size_t count) {
  return as_integers(many(10, count));
}

}  // namespace tapfit::acquisition
