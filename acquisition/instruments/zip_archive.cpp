#include "acquisition/instruments/zip_archive.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/instruments/byte_cursor.hpp"
#include "acquisition/readers/inflate.hpp"
#include "acquisition/readers/mapped_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string_view>

namespace tapfit::acquisition {
namespace {

constexpr std::uint32_t all_ones = 0xffffffff;  // the number stands elsewhere

InputError no_archive(const std::filesystem::path& file) {
  return {"is no whole zip archive",
          file.string(),
          "copy the file again, or save it anew with numpy.savez"};
}

// Where the list begins and how many entries it has; it ends the archive, with
// a comment of 64 kB at most behind it.
struct ZipList {
  std::uint64_t begin = 0;
  std::uint64_t count = 0;
};

// Of archives beyond 4 GB, in front of the usual end.
void find_long_list(std::string_view bytes,
                    std::size_t end,
                    const std::filesystem::path& file,
                    ZipList& list) {
  constexpr std::size_t locator = 20;
  if (end < locator ||
      bytes.substr(end - locator, 4) != std::string_view("PK\x06\x07", 4)) {
    return;
  }
  ByteCursor cursor(bytes, file);
  cursor.go_to(end - locator + 8);
  cursor.go_to(cursor.number<std::uint64_t>());
  if (cursor.bytes(4) != std::string_view("PK\x06\x06", 4)) {
    throw no_archive(file);
  }
  (void)cursor.bytes(28);
  list.count = cursor.number<std::uint64_t>();
  (void)cursor.number<std::uint64_t>();
  list.begin = cursor.number<std::uint64_t>();
}

ZipList find_list(std::string_view bytes, const std::filesystem::path& file) {
  constexpr std::size_t longest_end = 22 + 65535;
  const std::size_t from = bytes.size() - std::min(bytes.size(), longest_end);
  const std::size_t end =
      bytes.substr(from).rfind(std::string_view("PK\x05\x06", 4));
  if (end == std::string_view::npos) throw no_archive(file);
  ByteCursor cursor(bytes, file);
  cursor.go_to(from + end + 10);
  ZipList list;
  list.count = cursor.number<std::uint16_t>();
  (void)cursor.number<std::uint32_t>();
  list.begin = cursor.number<std::uint32_t>();
  if (list.begin == all_ones || list.count == 0xffff) {
    find_long_list(bytes, from + end, file, list);
  }
  return list;
}

// Numbers of 64 bits, in this order, for those that are all ones.
void read_long_numbers(std::string_view extra,
                       const std::filesystem::path& file,
                       ZipEntry& entry) {
  ByteCursor cursor(extra, file);
  while (cursor.left() >= 4) {
    const auto kind = cursor.number<std::uint16_t>();
    const std::string_view field = cursor.bytes(cursor.number<std::uint16_t>());
    if (kind != 1) continue;
    ByteCursor numbers(field, file);
    for (std::uint64_t* number : {&entry.size, &entry.packed, &entry.begin}) {
      if (*number == all_ones) *number = numbers.number<std::uint64_t>();
    }
  }
}

ZipEntry read_entry(ByteCursor& cursor, const std::filesystem::path& file) {
  if (cursor.bytes(4) != std::string_view("PK\x01\x02", 4)) {
    throw no_archive(file);
  }
  ZipEntry entry;
  (void)cursor.bytes(4);
  const auto flags = cursor.number<std::uint16_t>();
  entry.method = cursor.number<std::uint16_t>();
  if ((flags & 1U) != 0) entry.method = -1;  // encrypted
  (void)cursor.bytes(4);
  entry.checksum = cursor.number<std::uint32_t>();
  entry.packed = cursor.number<std::uint32_t>();
  entry.size = cursor.number<std::uint32_t>();
  const auto name = cursor.number<std::uint16_t>();
  const auto extra = cursor.number<std::uint16_t>();
  const auto comment = cursor.number<std::uint16_t>();
  (void)cursor.bytes(8);
  entry.begin = cursor.number<std::uint32_t>();
  entry.name = cursor.bytes(name);
  read_long_numbers(cursor.bytes(extra), file, entry);
  (void)cursor.bytes(comment);
  return entry;
}

// The local header repeats the entry, with lengths of its own.
std::uint64_t begin_of_bytes(std::string_view bytes,
                             const ZipEntry& entry,
                             const std::filesystem::path& file) {
  ByteCursor cursor(bytes, file);
  cursor.go_to(entry.begin);
  if (cursor.bytes(4) != std::string_view("PK\x03\x04", 4)) {
    throw no_archive(file);
  }
  (void)cursor.bytes(22);
  const auto name = cursor.number<std::uint16_t>();
  const auto extra = cursor.number<std::uint16_t>();
  (void)cursor.bytes(std::uint64_t{name} + extra);
  const std::uint64_t begin = cursor.at();
  (void)cursor.bytes(entry.packed);
  return begin;
}

InputError does_not_unpack(const ZipEntry& entry,
                           const std::filesystem::path& file) {
  return {fmt::format("is damaged: \"{}\" does not unpack", entry.name),
          file.string(),
          "copy the file again, or save it anew"};
}

// Deflate packs 1032 bytes into one at most.
void check_size(const ZipEntry& entry, const std::filesystem::path& file) {
  const bool stored = entry.method == 0;
  if (!stored && entry.method != 8) {
    throw InputError(
        fmt::format("\"{}\" is encrypted or packed in a way that is not read",
                    entry.name),
        file.string(),
        "save it with numpy.savez or numpy.savez_compressed");
  }
  if (stored ? entry.size != entry.packed : entry.size / 1033 > entry.packed) {
    throw does_not_unpack(entry, file);
  }
  if (static_cast<double>(entry.size) <= most_matrix_bytes()) return;
  throw InputError(
      fmt::format("\"{}\" is larger than memory holds", entry.name),
      file.string(),
      "save a part of it; if it is not that large, the file is damaged");
}

}  // namespace

std::vector<ZipEntry> list_zip(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  return mapped.reading([&] {
    const ZipList list = find_list(mapped.text(), file);
    ByteCursor cursor(mapped.text(), file);
    cursor.go_to(list.begin);
    std::vector<ZipEntry> entries;
    for (std::uint64_t k = 0; k < list.count; ++k) {
      entries.push_back(read_entry(cursor, file));
    }
    return entries;
  });
}

std::string unzip(const ZipEntry& entry, const std::filesystem::path& file) {
  check_size(entry, file);
  const MappedFile mapped(file);
  return mapped.reading([&] {
    const std::uint64_t begin = begin_of_bytes(mapped.text(), entry, file);
    std::string bytes(entry.size, '\0');
    if (entry.method == 0) {
      bytes = mapped.text().substr(begin, entry.size);
    } else {
      std::ifstream in = open_input(file);
      in.seekg(static_cast<std::streamoff>(begin));
      Inflate packed(in, entry.packed, Inflate::Wrapping::None);
      unsigned char over = 0;
      if (packed.unpack(reinterpret_cast<unsigned char*>(bytes.data()),
                        bytes.size()) != bytes.size() ||
          packed.unpack(&over, 1) != 0 || !packed.ended_well()) {
        throw does_not_unpack(entry, file);
      }
    }
    if (crc32_of(bytes) != entry.checksum) throw does_not_unpack(entry, file);
    return bytes;
  });
}

}  // namespace tapfit::acquisition
