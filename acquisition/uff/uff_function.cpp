#include "acquisition/uff/uff_function.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/uff/uff_numbers.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

namespace tapfit::acquisition {
namespace {

// Numbers that make one value.
std::size_t per_value(const UffHeader& header) {
  return (header.complex ? 2u : 1u) + (header.even ? 0u : 1u);
}

std::size_t all_values(const UffHeader& header) {
  return per_value(header) * static_cast<std::size_t>(header.count);
}

std::optional<Dof> dof(std::string_view line, std::size_t at) {
  const int direction = integer(column(line, at + 10, 4));
  if (direction == 0 || std::abs(direction) > 6) return std::nullopt;
  return Dof{integer(column(line, at, 10)),
             std::abs(direction),
             direction < 0 ? -1 : 1};
}

UffAxis axis(std::string_view line) {
  return {integer(column(line, 0, 10)), printable(column(line, 47, 20))};
}

void read_layout(const UffDataset& dataset, UffHeader& result) {
  const std::string_view line = dataset.lines[6];
  const int type = integer(column(line, 0, 10));
  if (type != 2 && type != 4 && type != 5 && type != 6)
    throw InputError(
        fmt::format("ordinate data type {} is none of 2, 4, 5, 6", type),
        dataset.place,
        "check record 7 of the dataset");
  result.complex = type >= 5;
  result.is_double = type == 4 || type == 6;
  result.count = integer(column(line, 10, 10));
  result.even = integer(column(line, 20, 10)) != 0;
  // Written by some with wider fields; the numbers after three integers.
  std::vector<double> rest;
  if (line.size() > 30 && numbers(line.substr(30), 13, rest)) {
    if (!rest.empty()) result.min = rest[0];
    if (rest.size() > 1) result.step = rest[1];
  }
  // A count that the file cannot hold must not be allocated: each value takes
  // two characters at least.
  const std::size_t size = dataset.data.size();
  const std::string_view said = column(line, 10, 10);
  if (result.count <= 0 || all_values(result) > size)
    throw InputError(fmt::format("{} values are announced, {} bytes are there",
                                 said.empty() ? "no" : said,
                                 size),
                     dataset.place,
                     "the file is cut off or record 7 is wrong");
}

// Binary data: an uneven abscissa is single precision, even beside doubles.
std::vector<double> binary_values(const UffDataset& dataset,
                                  const UffHeader& shape) {
  std::vector<double> values;
  values.reserve(all_values(shape));
  std::size_t at = 0;
  for (std::size_t i = 0; i < all_values(shape); ++i) {
    const bool abscissa = !shape.even && i % per_value(shape) == 0;
    const bool wide = shape.is_double && !abscissa;
    const std::size_t size = wide ? 8 : 4;
    if (at + size > dataset.data.size()) break;
    const char* from = dataset.data.data() + at;
    values.push_back(wide ? uff_double(from, dataset.big_endian)
                          : uff_single(from, dataset.big_endian));
    at += size;
  }
  return values;
}

std::vector<double> text_values(const UffDataset& dataset,
                                const UffHeader& shape) {
  std::vector<double> values;
  values.reserve(all_values(shape));
  int number = 0;
  for (std::size_t at = 0; at < dataset.data.size();) {
    take_uff_line(dataset,
                  next_line(dataset.data, at),
                  ++number,
                  shape.is_double,
                  values);
  }
  return values;
}

// Numbers in binary data; the last value may have lost some of its own.
std::size_t count_binary(const UffDataset& dataset, const UffHeader& shape) {
  const std::size_t wide = shape.is_double ? 8 : 4;
  const std::size_t lead = shape.even ? 0 : 4;
  const std::size_t bytes = lead + (shape.complex ? 2 * wide : wide);
  const std::size_t whole = dataset.data.size() / bytes * per_value(shape);
  const std::size_t left = dataset.data.size() % bytes;
  if (left < lead) return whole;
  return whole + (lead > 0 ? 1 : 0) + (left - lead) / wide;
}

std::size_t count_text(const UffDataset& dataset,
                       const UffHeader& shape,
                       const std::function<void(std::string_view)>& passed) {
  constexpr std::size_t now_and_then = 16 << 20;
  std::vector<double> values;
  std::size_t count = 0;
  std::size_t told = 0;
  int number = 0;
  for (std::size_t at = 0; at < dataset.data.size();) {
    values.clear();
    take_uff_line(dataset,
                  next_line(dataset.data, at),
                  ++number,
                  shape.is_double,
                  values);
    count += values.size();
    if (!passed || at - told < now_and_then) continue;
    passed(dataset.data.substr(told, at - told));
    told = at;
  }
  return count;
}

void take_values(const std::vector<double>& values, UffFunction& function) {
  const UffHeader& shape = function;
  function.x.resize(shape.count);
  function.y.resize(shape.count);
  const std::size_t stride = per_value(shape);
  const std::size_t lead = shape.even ? 0 : 1;
  for (Eigen::Index i = 0; i < shape.count; ++i) {
    const std::size_t at = static_cast<std::size_t>(i) * stride;
    function.x(i) = shape.even ? shape.min + static_cast<double>(i) * shape.step
                               : values[at];
    function.y(i) = {values[at + lead],
                     shape.complex ? values[at + lead + 1] : 0.0};
  }
}

}  // namespace

int function_type(const UffDataset& dataset) {
  return dataset.lines.size() > 5 ? integer(column(dataset.lines[5], 0, 5)) : 0;
}

UffHeader read_header(const UffDataset& dataset) {
  if (dataset.lines.size() < function_header_lines)
    throw InputError(fmt::format("a function has {} of {} header lines",
                                 dataset.lines.size(),
                                 function_header_lines),
                     dataset.place,
                     "the file is cut off; export it anew");
  UffHeader header;
  for (std::size_t i = 0; i < 5; ++i)
    header.id[i] = printable(column(dataset.lines[i], 0, 80));
  const std::string_view who = dataset.lines[5];
  header.function_type = integer(column(who, 0, 5));
  header.number = integer(column(who, 5, 10));
  header.response = dof(who, 41);
  header.reference = dof(who, 66);
  header.abscissa = axis(dataset.lines[7]);
  header.numerator = axis(dataset.lines[8]);
  header.denominator = axis(dataset.lines[9]);
  read_layout(dataset, header);
  return header;
}

UffHeader check_function(const UffDataset& dataset,
                         const std::function<void(std::string_view)>& passed) {
  UffHeader header = read_header(dataset);
  const std::size_t count = dataset.binary
                                ? count_binary(dataset, header)
                                : count_text(dataset, header, passed);
  if (count < all_values(header))
    throw uff_cut_off(dataset, count, all_values(header));
  return header;
}

UffFunction read_function(const UffDataset& dataset) {
  UffFunction function{read_header(dataset), {}, {}};
  const std::vector<double> values = dataset.binary
                                         ? binary_values(dataset, function)
                                         : text_values(dataset, function);
  if (values.size() < all_values(function))
    throw uff_cut_off(dataset, values.size(), all_values(function));
  take_values(values, function);
  return function;
}

std::optional<double> number_in_id(const std::array<std::string, 5>& id,
                                   std::string_view key) {
  for (const std::string& line : id) {
    const std::size_t at = line.find(key);
    if (at == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(' ', at + key.size());
    if (begin == std::string::npos) continue;
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    double value = 0.0;
    if (parse_number(std::string_view(line).substr(begin, end - begin),
                     value) &&
        std::isfinite(value)) {
      return value;
    }
  }
  return std::nullopt;
}

}  // namespace tapfit::acquisition
