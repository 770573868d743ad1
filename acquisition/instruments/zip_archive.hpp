// Files within a zip archive, stored or deflated, as numpy.savez and
// numpy.savez_compressed write them.
//
// Source: PKWARE, "APPNOTE.TXT - .ZIP File Format Specification", 6.3.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct ZipEntry {
  std::string name;
  std::uint64_t packed = 0;  ///< bytes in the archive
  std::uint64_t size = 0;    ///< bytes when unpacked
  std::uint64_t begin = 0;   ///< of its local header
  std::uint32_t checksum = 0;
  int method = 0;  ///< 0 stored, 8 deflated
};

/// The archive's own list of what it holds.
/// @throws InputError for a file that is none or ends early
[[nodiscard]] std::vector<ZipEntry> list_zip(const std::filesystem::path& file);

/// The bytes of one of them.
/// @throws InputError for a method that is not known, for what does not unpack
///   to what is announced, for more than memory holds
[[nodiscard]] std::string unzip(const ZipEntry& entry,
                                const std::filesystem::path& file);

}  // namespace tapfit::acquisition
