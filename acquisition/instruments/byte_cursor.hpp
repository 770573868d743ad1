// Numbers and texts taken one after the other from the bytes of a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

namespace tapfit::acquisition {

enum class ByteOrder { Little, Big };

/// A number of one of C++'s types in either byte order.
template <class Number>
Number number_at(const char* at, ByteOrder order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), at, sizeof(Number));
  const bool as_here = (order == ByteOrder::Little) ==
                       (std::endian::native == std::endian::little);
  if (!as_here) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Where reading has come to. Nothing behind the end is ever taken.
class ByteCursor {
 public:
  ByteCursor(std::string_view bytes,
             const std::filesystem::path& file,
             ByteOrder order = ByteOrder::Little)
      : bytes_(bytes), file_(&file), order_(order) {}

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  void set_order(ByteOrder order) { order_ = order; }

  /// @throws InputError with the byte where the file ends early; so do all
  std::string_view bytes(std::uint64_t count);
  void go_to(std::uint64_t at);

  template <class Number>
  Number number() {
    return number_at<Number>(bytes(sizeof(Number)).data(), order_);
  }
  /// A length of four bytes and as many characters.
  std::string text() { return std::string(bytes(number<std::uint32_t>())); }

 private:
  std::string_view bytes_;
  const std::filesystem::path* file_;
  ByteOrder order_;
  std::size_t at_ = 0;
};

}  // namespace tapfit::acquisition
