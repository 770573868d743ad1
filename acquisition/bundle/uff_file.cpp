#include "acquisition/bundle/uff_file.hpp"

#include <fstream>
#include <iomanip>
#include <system_error>

namespace tapfit::acquisition {

UffFile open_uff(const std::filesystem::path& file) {
  UffFile result{MappedFile(file), file.filename().string(), {}};
  const MappedFile& bytes = result.bytes;
  result.datasets = bytes.reading([&] {
    return split_uff(bytes.text(), result.name, [&](std::string_view part) {
      bytes.forget(part);
    });
  });
  return result;
}

const UffDataset& dataset_of(const UffFile& file, std::size_t number) {
  if (number < file.datasets.size()) return file.datasets[number];
  throw InputError("holds fewer datasets than when it was first read",
                   file.name,
                   "wait until it is written, or copy it again");
}

bool is_uff(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::ifstream in(file, std::ios::binary);
  // A file without blanks would come in whole.
  constexpr int enough = 4;
  std::string begin;
  return static_cast<bool>(in >> std::setw(enough) >> begin) && begin == "-1";
}

}  // namespace tapfit::acquisition
