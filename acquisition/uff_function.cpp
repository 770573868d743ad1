#include "acquisition/uff_function.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace tapfit::acquisition {
namespace {

constexpr std::size_t header_lines = 11;

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
  return {integer(column(line, 0, 10)), std::string(column(line, 47, 20))};
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
  std::size_t size = dataset.bytes.size();
  for (std::size_t i = header_lines; i < dataset.lines.size(); ++i)
    size += dataset.lines[i].size() + 1;
  if (result.count <= 0 || all_values(result) > size)
    throw InputError(
        fmt::format(
            "{} values are announced, {} bytes are there", result.count, size),
        dataset.place,
        "the file is cut off or record 7 is wrong");
}

template <class Float, class Bits>
double from_bytes(const char* at, bool big_endian) {
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    const std::size_t place = big_endian ? sizeof(Bits) - 1 - i : i;
    bits |= static_cast<Bits>(
        static_cast<Bits>(static_cast<unsigned char>(at[i])) << (8 * place));
  }
  return static_cast<double>(std::bit_cast<Float>(bits));
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
    if (at + size > dataset.bytes.size()) break;
    const char* from = dataset.bytes.data() + at;
    values.push_back(
        wide ? from_bytes<double, std::uint64_t>(from, dataset.big_endian)
             : from_bytes<float, std::uint32_t>(from, dataset.big_endian));
    at += size;
  }
  return values;
}

// Adds the numbers of a data line.
void take_line(const UffDataset& dataset,
               std::size_t i,
               const UffHeader& shape,
               std::vector<double>& values) {
  if (numbers(dataset.lines[i], shape.is_double ? 20 : 13, values)) return;
  throw InputError(
      fmt::format("\"{}\" is no line of numbers", dataset.lines[i]),
      fmt::format("{}, data line {}", dataset.place, i - header_lines + 1),
      "export the function anew");
}

std::vector<double> text_values(const UffDataset& dataset,
                                const UffHeader& shape) {
  std::vector<double> values;
  values.reserve(all_values(shape));
  for (std::size_t i = header_lines; i < dataset.lines.size(); ++i) {
    take_line(dataset, i, shape, values);
  }
  return values;
}

// How many of the values a text holds; more than wanted are passed over.
Eigen::Index text_into(const UffDataset& dataset,
                       const UffHeader& shape,
                       Eigen::Ref<Eigen::VectorXd> values) {
  std::vector<double> line;
  Eigen::Index done = 0;
  for (std::size_t i = header_lines; i < dataset.lines.size(); ++i) {
    line.clear();
    take_line(dataset, i, shape, line);
    for (const double value : line) {
      if (done < values.size()) values[done++] = value;
    }
  }
  return done;
}

template <class Float, class Bits>
Eigen::Index bytes_into(const UffDataset& dataset,
                        Eigen::Ref<Eigen::VectorXd> values) {
  const auto there =
      static_cast<Eigen::Index>(dataset.bytes.size() / sizeof(Bits));
  const Eigen::Index count = std::min(there, values.size());
  const char* at = dataset.bytes.data();
  for (Eigen::Index i = 0; i < count; ++i, at += sizeof(Bits)) {
    values[i] = from_bytes<Float, Bits>(at, dataset.big_endian);
  }
  return count;
}

InputError too_few(const UffDataset& dataset,
                   std::size_t there,
                   std::size_t wanted) {
  return {fmt::format("{} of {} numbers are there", there, wanted),
          dataset.place,
          "the file is cut off; export it anew"};
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
  if (dataset.lines.size() < header_lines)
    throw InputError(fmt::format("a function has {} of {} header lines",
                                 dataset.lines.size(),
                                 header_lines),
                     dataset.place,
                     "the file is cut off; export it anew");
  UffHeader header;
  for (std::size_t i = 0; i < 5; ++i)
    header.id[i] = std::string(column(dataset.lines[i], 0, 80));
  const std::string_view who = dataset.lines[5];
  header.function_type = integer(column(who, 0, 5));
  header.number = integer(column(who, 5, 10));
  header.response_entity = std::string(column(who, 31, 10));
  header.response = dof(who, 41);
  header.reference = dof(who, 66);
  header.abscissa = axis(dataset.lines[7]);
  header.numerator = axis(dataset.lines[8]);
  header.denominator = axis(dataset.lines[9]);
  read_layout(dataset, header);
  return header;
}

void read_values(const UffDataset& dataset,
                 const UffHeader& header,
                 Eigen::Ref<Eigen::VectorXd> values) {
  assert(header.even && !header.complex && values.size() == header.count);
  const Eigen::Index there =
      !dataset.binary    ? text_into(dataset, header, values)
      : header.is_double ? bytes_into<double, std::uint64_t>(dataset, values)
                         : bytes_into<float, std::uint32_t>(dataset, values);
  if (there < header.count)
    throw too_few(dataset,
                  static_cast<std::size_t>(there),
                  static_cast<std::size_t>(header.count));
}

UffFunction read_function(const UffDataset& dataset) {
  UffFunction function{read_header(dataset), {}, {}};
  const std::vector<double> values = dataset.binary
                                         ? binary_values(dataset, function)
                                         : text_values(dataset, function);
  if (values.size() < all_values(function))
    throw too_few(dataset, values.size(), all_values(function));
  take_values(values, function);
  return function;
}

}  // namespace tapfit::acquisition
