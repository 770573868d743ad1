// Arrays and archives of numpy byte by byte, for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>
#include <zlib.h>

namespace tapfit::testing {

/// Numbers of any type in the order of this machine, which is little endian.
template <class Number>
std::string bytes_of_numbers(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

inline std::string little(std::uint64_t number, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(number >> 8 * k);
  return text;
}

/// @param type as numpy writes it, "<f8"
/// @param shape "(3, 2)"
inline std::string npy(const std::string& type,
                       const std::string& shape,
                       const std::string& values,
                       bool columns_first = false,
                       int version = 1) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " +
                       (columns_first ? "True" : "False") +
                       ", 'shape': " + shape + ", }";
  const std::size_t begin = version == 1 ? 10 : 12;
  header.resize((begin + header.size() + 64) / 64 * 64 - begin - 1, ' ');
  header += '\n';
  return std::string("\x93NUMPY", 6) + static_cast<char>(version) + '\0' +
         little(header.size(), version == 1 ? 2 : 4) + header + values;
}

inline std::string npy(const std::vector<double>& values) {
  return npy("<f8",
             "(" + std::to_string(values.size()) + ",)",
             bytes_of_numbers(values));
}

/// A zip archive of files, stored or deflated.
inline std::string zip(
    const std::vector<std::pair<std::string, std::string>>& files,
    bool deflated) {
  std::string archive;
  std::string list;
  for (const auto& [name, content] : files) {
    std::string packed = content;
    if (deflated) {
      z_stream stream{};
      deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
      packed.resize(deflateBound(&stream, content.size()));
      stream.next_in =
          reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
      stream.avail_in = static_cast<uInt>(content.size());
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      deflate(&stream, Z_FINISH);
      packed.resize(stream.total_out);
      deflateEnd(&stream);
    }
    const std::string facts =
        little(20, 2) + little(0, 2) + little(deflated ? 8 : 0, 2) +
        little(0, 4) +
        little(crc32(0,
                     reinterpret_cast<const Bytef*>(content.data()),
                     static_cast<uInt>(content.size())),
               4) +
        little(packed.size(), 4) + little(content.size(), 4) +
        little(name.size(), 2);
    list += "PK\x01\x02" + little(20, 2) + facts + little(0, 2) + little(0, 2) +
            little(0, 8) + little(archive.size(), 4) + name;
    archive += "PK\x03\x04" + facts + little(0, 2) + name + packed;
  }
  return archive + list + "PK\x05\x06" + little(0, 4) +
         little(files.size(), 2) + little(files.size(), 2) +
         little(list.size(), 4) + little(archive.size(), 4) + little(0, 2);
}

}  // namespace tapfit::testing
