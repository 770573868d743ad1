#include "acquisition/readers/sample_bytes.hpp"

#include <fstream>
#include <string>

namespace tapfit::acquisition {
namespace {

struct Container {
  std::uint64_t first = 0;      ///< where the first chunk begins
  std::uint64_t id = 4;         ///< bytes of a chunk's name
  std::uint64_t length = 4;     ///< bytes of its length
  bool with_head = false;       ///< the length counts name and length too
  std::uint64_t alignment = 1;  ///< chunks begin at multiples of it

  [[nodiscard]] std::uint64_t head() const { return id + length; }
};

std::optional<Container> container_of(std::string_view begin) {
  if (begin == "RF64") return Container{.first = 12, .alignment = 2};
  if (begin == "riff")
    return Container{
        .first = 40, .id = 16, .length = 8, .with_head = true, .alignment = 8};
  return std::nullopt;
}

std::string bytes_at(std::ifstream& in, std::uint64_t at, std::uint64_t count) {
  std::string bytes(count, '\0');
  in.seekg(static_cast<std::streamoff>(at));
  if (!in.read(bytes.data(), static_cast<std::streamsize>(count))) return {};
  return bytes;
}

// The lowest byte first.
std::uint64_t number(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t k = bytes.size(); k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[k]);
  }
  return value;
}

// All ones, or all but a head's worth.
bool is_open(std::uint64_t length) { return length >= ~std::uint64_t{0xFF}; }

}  // namespace

std::optional<SampleBytes> sample_bytes(const std::filesystem::path& file) {
  std::error_code fault;
  const std::uint64_t size = std::filesystem::file_size(file, fault);
  std::ifstream in(file, std::ios::binary);
  const auto kind = container_of(bytes_at(in, 0, 4));
  if (fault || !kind) return std::nullopt;
  const bool rf64 = kind->length == 4;
  std::uint64_t long_length = ~std::uint64_t{0};  // of ds64
  for (std::uint64_t at = kind->first; at < size;) {
    const std::string head = bytes_at(in, at, kind->head());
    if (head.empty()) return std::nullopt;
    std::uint64_t length = number(head.substr(kind->id));
    if (kind->with_head && length < kind->head()) return std::nullopt;
    if (kind->with_head && !is_open(length)) length -= kind->head();
    at += kind->head();
    if (head.starts_with("data")) {
      if (rf64 && length == 0xFFFFFFFF) length = long_length;
      if (is_open(length)) return std::nullopt;
      return SampleBytes{length, size - at};
    }
    // Riff length and the samples' own stand first.
    if (rf64 && head.starts_with("ds64"))
      long_length = number(bytes_at(in, at + 8, 8));
    if (length > size - at) return std::nullopt;
    at += length;
    at += (kind->alignment - at % kind->alignment) % kind->alignment;
  }
  return std::nullopt;
}

}  // namespace tapfit::acquisition
