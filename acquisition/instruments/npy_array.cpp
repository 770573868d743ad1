#include "acquisition/instruments/npy_array.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/instruments/binary_numbers.hpp"
#include "acquisition/instruments/byte_cursor.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr std::string_view npy_mark("\x93NUMPY", 6);

struct NpyHeader {
  std::string type;  ///< "<f8"; empty for records
  bool columns_first = false;
  std::vector<std::uint64_t> shape;
};

[[noreturn]] void throw_bad_header(const std::string& name,
                                   const std::filesystem::path& file) {
  throw InputError(
      fmt::format("the header of \"{}\" is none of numpy's", name),
      file.string(),
      "copy the file again, or save it anew with numpy.save or numpy.savez");
}

// What follows a key of the dictionary, up to the line's end.
std::string_view after_key(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = header.substr(at + key.size());
  const std::size_t begin = rest.find_first_not_of(" :");
  return begin == std::string_view::npos ? std::string_view()
                                         : rest.substr(begin);
}

std::optional<std::vector<std::uint64_t>> parse_shape(std::string_view text) {
  constexpr std::size_t most_dimensions = 32;
  const std::size_t end = text.find(')');
  if (!text.starts_with("(") || end == std::string_view::npos) return {};
  text = text.substr(1, end - 1);
  std::vector<std::uint64_t> shape;
  for (;;) {
    const std::size_t digit = text.find_first_not_of(" ,L");
    if (digit == std::string_view::npos) return shape;
    std::uint64_t side = 0;
    const char* stop = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data() + digit, stop, side);
    if (fault != std::errc{} || shape.size() == most_dimensions) return {};
    shape.push_back(side);
    text = text.substr(static_cast<std::size_t>(rest - text.data()));
  }
}

NpyHeader read_npy_header(ByteCursor& bytes,
                          const std::string& name,
                          const std::filesystem::path& file) {
  if (bytes.left() < 10 || bytes.bytes(6) != npy_mark) {
    throw_bad_header(name, file);
  }
  const auto version = bytes.number<std::uint8_t>();
  (void)bytes.number<std::uint8_t>();
  if (version < 1 || version > 3) throw_bad_header(name, file);
  const std::uint32_t length = version == 1 ? bytes.number<std::uint16_t>()
                                            : bytes.number<std::uint32_t>();
  const std::string_view text = bytes.bytes(length);
  NpyHeader header;
  const std::string_view type = after_key(text, "'descr'");
  if (type.starts_with("'")) {
    header.type = type.substr(1, type.find('\'', 1) - 1);
  } else if (!type.starts_with("[")) {
    throw_bad_header(name, file);
  }
  header.columns_first = after_key(text, "'fortran_order'").starts_with("True");
  const auto shape = parse_shape(after_key(text, "'shape'"));
  if (!shape) throw_bad_header(name, file);
  header.shape = *shape;
  return header;
}

std::optional<NumberType> number_type(std::string_view type) {
  struct Known {
    std::string_view text;
    NumberType type;
  };
  for (const Known& known : {Known{"i1", NumberType::Int8},
                             Known{"i2", NumberType::Int16},
                             Known{"i4", NumberType::Int32},
                             Known{"i8", NumberType::Int64},
                             Known{"u1", NumberType::Uint8},
                             Known{"u2", NumberType::Uint16},
                             Known{"u4", NumberType::Uint32},
                             Known{"u8", NumberType::Uint64},
                             Known{"b1", NumberType::Uint8},
                             Known{"f4", NumberType::Float32},
                             Known{"f8", NumberType::Float64}}) {
    if (type == known.text) return known.type;
  }
  return std::nullopt;
}

void append_utf8(std::uint32_t letter, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (letter < 0x80) {
    add(letter);
  } else if (letter < 0x800) {
    add(0xc0 | letter >> 6U);
    add(0x80 | (letter & 0x3fU));
  } else if (letter < 0x10000) {
    add(0xe0 | letter >> 12U);
    add(0x80 | (letter >> 6U & 0x3fU));
    add(0x80 | (letter & 0x3fU));
  } else {
    text += '?';  // no letter of a unit or name
  }
}

// Texts of one length each, filled up with zeros.
void read_npy_texts(ByteCursor& bytes,
                    const std::string& type,
                    double count,
                    NamedArray& array) {
  std::uint32_t letters = 0;
  const char* end = type.data() + type.size();
  const auto [stop, fault] = std::from_chars(type.data() + 2, end, letters);
  constexpr double most_texts = 1e5;
  if (fault != std::errc{} || stop != end || count > most_texts) return;
  const std::size_t width = type[1] == 'U' ? 4 : 1;
  const ByteOrder order = type[0] == '>' ? ByteOrder::Big : ByteOrder::Little;
  array.kind = NamedArray::Kind::Text;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const std::string_view cell = bytes.bytes(std::uint64_t{letters} * width);
    std::string text;
    for (std::size_t at = 0; at < cell.size(); at += width) {
      if (width == 1) {
        text += cell[at];
      } else {
        append_utf8(number_at<std::uint32_t>(cell.data() + at, order), text);
      }
    }
    array.texts.push_back(as_utf8(text.substr(0, text.find('\0'))));
  }
}

// Beside a side of none, any other would pass for no value at all.
constexpr std::uint64_t most_samples = std::uint64_t{1} << 62U;

// Rows and columns: those of one, before and between, do not count.
std::optional<std::array<std::uint64_t, 2>> sides_of(
    const std::vector<std::uint64_t>& shape) {
  std::array<std::uint64_t, 2> sides{1, 1};
  int count = 0;
  for (const std::uint64_t side : shape) {
    if (side == 1) continue;
    ++count;
    if (side > most_samples) return std::nullopt;
    sides = {sides[1], side};
  }
  if (count > 2) return std::nullopt;
  return sides;
}

// Where rows stand together in the file, they are the matrix's columns.
void read_npy_numbers(ByteCursor& bytes,
                      const NpyHeader& header,
                      std::array<std::uint64_t, 2> sides,
                      NumberType type,
                      NamedArray& array) {
  const std::uint64_t count = sides[0] * sides[1];
  const std::string_view numbers = bytes.bytes(count * size_of(type));
  if (!header.columns_first) std::swap(sides[0], sides[1]);
  array.kind = NamedArray::Kind::Numbers;
  array.values.resize(static_cast<Index>(sides[0]),
                      static_cast<Index>(sides[1]));
  const ByteOrder order =
      header.type[0] == '>' ? ByteOrder::Big : ByteOrder::Little;
  decode(
      numbers.data(), size_of(type), type, order, count, array.values.data());
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(npy_mark); }

NamedArray read_npy(std::string_view content,
                    const std::string& name,
                    const std::filesystem::path& file,
                    ArrayRoom& room) {
  ByteCursor bytes(content, file);
  const NpyHeader header = read_npy_header(bytes, name, file);
  NamedArray array{.name = name};
  const auto sides = sides_of(header.shape);
  if (!sides || header.type.size() < 3) return array;
  const double count =
      static_cast<double>((*sides)[0]) * static_cast<double>((*sides)[1]);
  const auto type = number_type(std::string_view(header.type).substr(1));
  if (type) {
    room.take(name, count);
    read_npy_numbers(bytes, header, *sides, *type, array);
  } else if (header.type[1] == 'U' || header.type[1] == 'S') {
    read_npy_texts(bytes, header.type, count, array);
  }
  return array;
}

}  // namespace tapfit::acquisition
