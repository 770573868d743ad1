#include "acquisition/readers/mat_elements.hpp"

#include "acquisition/foundation/input_file.hpp"
#include "acquisition/readers/inflate.hpp"
#include "acquisition/readers/named_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace tapfit::acquisition {
namespace {

using Length = std::uintmax_t;
using Tag = std::array<unsigned char, 8>;

std::uint32_t number_at(const unsigned char* at, bool little) {
  std::uint32_t value = 0;
  for (int k = 0; k < 4; ++k) value = value << 8U | at[little ? 3 - k : k];
  return value;
}

InputError damaged(const std::filesystem::path& file,
                   Length at,
                   const std::string& how) {
  return {"is damaged: " + how,
          fmt::format("{}, byte {}", file.string(), at),
          "copy the file again, or save it anew"};
}

InputError ends_early(const std::filesystem::path& file,
                      Length at,
                      double announced,
                      Length there) {
  return {fmt::format("ends early: {:.0f} bytes are announced, {} are there",
                      announced,
                      there),
          fmt::format("{}, byte {}", file.string(), at),
          "copy the file again, or save it anew"};
}

// Elements of versions 5 to 7 are a type, a length and as many bytes. Those of
// a matrix are elements again, its name one of them.
struct Element {
  std::uint32_t type = 0;
  Length length = 0;

  Element(const Tag& tag, bool little)
      : type(number_at(tag.data(), little)),
        // Small elements hold length and bytes within their tag.
        length(type >> 16U != 0 ? 0 : number_at(tag.data() + 4, little)) {}
  // The next one begins at a multiple of 8.
  [[nodiscard]] Length padded() const { return (length + 7) / 8 * 8; }
};

// Numbers that an element of data holds, by its type (miINT8 ... miUINT64).
double numbers_in(const Element& element) {
  constexpr std::array<Length, 14> widths{
      0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};
  const Length width = element.type < widths.size() ? widths[element.type] : 0;
  return width == 0 ? 0.0 : static_cast<double>(element.length / width);
}

constexpr std::uint32_t matrix = 14;
constexpr std::uint32_t packed = 15;

// What is packed there, taken tag by tag.
class PackedElements {
 public:
  PackedElements(std::ifstream& in, Length length)
      : bytes_(in, length, Inflate::Wrapping::Zlib) {}

  bool take(Tag& tag) {
    return bytes_.unpack(tag.data(), tag.size()) == tag.size();
  }
  bool skip(Length count) {
    while (count > 0) {
      const Length step = std::min<Length>(count, scratch_.size());
      if (bytes_.unpack(scratch_.data(), step) != step) return false;
      count -= step;
    }
    return true;
  }
  // Whether what is left, which is no more than padding, ends in a checksum
  // that is right.
  bool ends_well() {
    return bytes_.unpack(scratch_.data(), scratch_.size()) < scratch_.size() &&
           bytes_.ended_well();
  }

 private:
  Inflate bytes_;
  std::array<unsigned char, 1 << 14> scratch_{};
};

// What is said of memory, and whether to go on.
struct Bounds {
  ArrayRoom room;
  const Progress& progress;

  void pass(double numbers) {
    room.take("", numbers);
    progress("reading", 0.0);
  }
};

bool holds_what_it_says(PackedElements& bytes, bool little, Bounds& bounds) {
  Length at = 0;
  Length end = 8;
  while (at + 8 <= end) {
    Tag tag{};
    if (!bytes.take(tag)) return false;
    const Element element(tag, little);
    at += 8;
    if (at == 8) end = 8 + element.length;  // the outermost, around all others
    if (element.length > end - at) return false;
    if (element.type == matrix) continue;
    bounds.pass(numbers_in(element));
    const Length step = std::min(element.padded(), end - at);
    if (!bytes.skip(step)) return false;
    at += step;
  }
  return bytes.ends_well();
}

// Versions 5 to 7, behind a header of 128 bytes. Packed elements are only
// outermost ones, and touch the next.
void walk_elements(std::ifstream& in,
                   const std::filesystem::path& file,
                   Length end,
                   bool little,
                   Bounds& bounds) {
  for (Length at = 128; at + 8 <= end;) {
    Tag tag{};
    in.seekg(static_cast<std::streamoff>(at));
    in.read(reinterpret_cast<char*>(tag.data()), tag.size());
    if (!in) return;
    const Element element(tag, little);
    // A file that was never written to its end is zeros from there on.
    if (element.type == 0) throw damaged(file, at, "nothing is stored there");
    const Length there = end - at - 8;
    if (element.length > there) {
      throw ends_early(file, at, static_cast<double>(element.length), there);
    }
    if (element.type == packed) {
      PackedElements bytes(in, element.length);
      if (!holds_what_it_says(bytes, little, bounds)) {
        throw damaged(file, at, "what is packed there does not unpack");
      }
      in.clear();
    } else {
      bounds.pass(numbers_in(element));
    }
    at += 8;
    if (element.type == matrix) continue;  // its own elements come next
    at += element.type == packed ? element.length : element.padded();
  }
}

// Version 4: variables of five numbers (type, rows, columns, imaginary part,
// length of the name), the name and the values. The type's decimal digits are
// byte order, 0, width of a value, kind of matrix.
void walk_variables(std::ifstream& in,
                    const std::filesystem::path& file,
                    Length size,
                    Bounds& bounds) {
  constexpr std::array<double, 6> widths{8, 4, 4, 2, 2, 1};
  constexpr std::uint32_t largest_type = 4052;
  for (Length at = 0; at + 20 <= size;) {
    std::array<unsigned char, 20> header{};
    in.seekg(static_cast<std::streamoff>(at));
    in.read(reinterpret_cast<char*>(header.data()), header.size());
    if (!in) return;
    std::uint32_t type = number_at(header.data(), true);
    if (type > largest_type) type = number_at(header.data(), false);
    const std::size_t order = type / 1000;  // 0: little endian, 1: big
    const std::size_t width = type / 10 % 10;
    const auto number = [&](int k) {
      return number_at(header.data() + 4 * k, order == 0);
    };
    // Each has a name, with a zero behind it.
    if (type > largest_type || order > 1 || width >= widths.size() ||
        number(4) == 0) {
      throw no_mat_file(file);
    }
    const double values = static_cast<double>(number(1)) * number(2) *
                          (number(3) != 0 ? 2.0 : 1.0);
    const double length = number(4) + values * widths.at(width);
    if (length > static_cast<double>(size - at - 20)) {
      throw ends_early(file, at, length, size - at - 20);
    }
    bounds.pass(values);
    at += 20 + static_cast<Length>(length);
  }
}

// What versions from 5 on begin with: a text, the version and the byte order.
struct MatHeader {
  bool whole = false;  // else it is of version 4, or none
  bool little = false;
  int version = 0;

  explicit MatHeader(const std::filesystem::path& file) {
    std::ifstream in = open_input(file);
    std::array<unsigned char, 128> bytes{};
    in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    const std::string mark(bytes.begin() + 126, bytes.end());
    little = mark == "IM";
    whole = in && (little || mark == "MI");
    version = bytes[little ? 125 : 124];
  }
};

}  // namespace

InputError no_mat_file(const std::filesystem::path& file) {
  return {"cannot be read as a MATLAB file",
          file.string(),
          "save it with save -v7 (or -v6), and check its name"};
}

bool mat_is_hdf5(const std::filesystem::path& file) {
  const MatHeader header(file);
  return header.whole && header.version == 2;
}

void check_mat_elements(const std::filesystem::path& file,
                        const Progress& progress) {
  const MatHeader header(file);
  std::error_code ignored;
  const Length size = std::filesystem::file_size(file, ignored);
  if (ignored) return;
  std::ifstream in = open_input(file);
  Bounds bounds{ArrayRoom(file), progress};
  if (!header.whole) {
    walk_variables(in, file, size, bounds);
  } else if (header.version == 1) {
    walk_elements(in, file, size, header.little, bounds);
  }
}

}  // namespace tapfit::acquisition
