#include "acquisition/instruments/numpy_file.hpp"

#include "acquisition/foundation/input_file.hpp"
#include "acquisition/instruments/npy_array.hpp"
#include "acquisition/instruments/zip_archive.hpp"
#include "acquisition/readers/mapped_file.hpp"

#include <fstream>
#include <string>
#include <string_view>

namespace tapfit::acquisition {
namespace {

std::string first_bytes(const std::filesystem::path& file) {
  std::string bytes(8, '\0');
  std::ifstream in = open_input(file);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return in ? bytes : std::string();
}

// Before one of them is unpacked; small numbers may be more than these.
void refuse_sum(const std::vector<ZipEntry>& entries,
                const std::filesystem::path& file) {
  ArrayRoom together(file);
  for (const ZipEntry& entry : entries) {
    together.take(entry.name, static_cast<double>(entry.size) / sizeof(double));
  }
}

}  // namespace

bool is_npy_file(const std::filesystem::path& file) {
  return is_npy(first_bytes(file));
}

bool is_npz_file(const std::filesystem::path& file) {
  return first_bytes(file).starts_with(std::string_view("PK\x03\x04", 4));
}

std::vector<NamedArray> read_npy_arrays(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  return mapped.reading([&] {
    ArrayRoom room(file);
    return std::vector{
        read_npy(mapped.text(), file.stem().string(), file, room)};
  });
}

std::vector<NamedArray> read_npz_arrays(const std::filesystem::path& file) {
  const std::vector<ZipEntry> entries = list_zip(file);
  refuse_sum(entries, file);
  ArrayRoom room(file);
  std::vector<NamedArray> arrays;
  for (const ZipEntry& entry : entries) {
    if (!entry.name.ends_with(".npy")) continue;
    const std::string name = entry.name.substr(0, entry.name.size() - 4);
    arrays.push_back(read_npy(unzip(entry, file), name, file, room));
  }
  return arrays;
}

}  // namespace tapfit::acquisition
