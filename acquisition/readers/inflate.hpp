// Packed bytes of a file unpacked piece by piece, and bytes packed, by way of
// zlib (included only here).
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// Unpacks the next `length` bytes of a stream. No more memory is taken than
/// what the caller asks for, whatever the packed bytes announce.
class Inflate {
 public:
  enum class Wrapping { Zlib, None };

  Inflate(std::istream& in, std::uintmax_t length, Wrapping wrapping);
  ~Inflate();
  Inflate(const Inflate&) = delete;
  Inflate& operator=(const Inflate&) = delete;

  /// @return how many of `count` bytes there were
  std::uintmax_t unpack(unsigned char* to, std::uintmax_t count);

  /// Whether all was unpacked and its checksum, where it has one, is right.
  [[nodiscard]] bool ended_well() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Packed as zlib does (RFC 1950), quickly rather than small.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// CRC-32 of the bytes, as archives keep it of each file.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes);

/// The version of zlib that is in use.
[[nodiscard]] std::string packing_library();

}  // namespace tapfit::acquisition
