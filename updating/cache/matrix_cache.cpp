#include "updating/cache/matrix_cache.hpp"

#include "acquisition/foundation/cache_folder.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

using Eigen::Index;
using Eigen::MatrixXd;
using Sizes = std::vector<std::array<std::int64_t, 2>>;  // rows, columns

constexpr std::string_view ending = ".matrices";
constexpr std::size_t most_matrices = 10000;

struct Head {
  std::array<char, 8> magic = {'t', 'a', 'p', 'f', 'i', 't', 'M', 'X'};
  std::uint32_t version = 1;
  std::uint32_t byte_order = 0x01020304;
  Digest key{};
  Digest content{};  // of sizes and numbers
  std::uint64_t matrices = 0;

  bool operator==(const Head&) const = default;
};

fs::path file_of(const MatrixCache& cache, const Digest& key) {
  return cache.folder / (hexadecimal(key) + std::string(ending));
}

template <class T>
void write(std::ostream& file, const T* items, std::size_t count) {
  file.write(reinterpret_cast<const char*>(items),
             static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
bool read(std::ifstream& file, T* items, std::size_t count) {
  return static_cast<bool>(
      file.read(reinterpret_cast<char*>(items),
                static_cast<std::streamsize>(count * sizeof(T))));
}

Digest content_of(const Sizes& sizes, const std::vector<MatrixXd>& matrices) {
  std::vector<Digest> parts = {digest_of(std::as_bytes(std::span(sizes)))};
  for (const MatrixXd& matrix : matrices) {
    const std::span<const double> numbers(
        matrix.data(), static_cast<std::size_t>(matrix.size()));
    parts.push_back(digest_of(std::as_bytes(numbers)));
  }
  return digest_of(std::as_bytes(std::span(parts)));
}

// Bytes of a file that holds matrices of these sizes; empty when no file does.
std::optional<std::uintmax_t> length_of(const Sizes& sizes) {
  constexpr double most = 1e15;
  double numbers = 0.0;
  for (const auto& [rows, columns] : sizes) {
    if (rows < 0 || columns < 0) return std::nullopt;
    numbers += static_cast<double>(rows) * static_cast<double>(columns);
  }
  if (numbers > most) return std::nullopt;
  return sizeof(Head) + sizes.size() * sizeof(Sizes::value_type) +
         static_cast<std::uintmax_t>(numbers) * sizeof(double);
}

// The file's matrices where its sizes agree with its length.
std::optional<std::vector<MatrixXd>> read_matrices(std::ifstream& file,
                                                   const Head& head,
                                                   std::uintmax_t length) {
  if (head.matrices > most_matrices) return std::nullopt;
  Sizes sizes(head.matrices);
  if (!read(file, sizes.data(), sizes.size())) return std::nullopt;
  if (length_of(sizes) != length) return std::nullopt;
  std::vector<MatrixXd> matrices;
  for (const auto& [rows, columns] : sizes) {
    matrices.emplace_back(static_cast<Index>(rows),
                          static_cast<Index>(columns));
    MatrixXd& last = matrices.back();
    if (!read(file, last.data(), static_cast<std::size_t>(last.size()))) {
      return std::nullopt;
    }
  }
  if (content_of(sizes, matrices) != head.content) return std::nullopt;
  return matrices;
}

void write_matrices(const fs::path& path,
                    const Head& head,
                    const Sizes& sizes,
                    const std::vector<MatrixXd>& matrices) {
  acquisition::OutputFile output(path, {{}, true});
  std::ostream& file = output.stream();
  write(file, &head, 1);
  write(file, sizes.data(), sizes.size());
  for (const MatrixXd& matrix : matrices) {
    write(file, matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
  output.commit();
}

// Files of this cache, parts of files that were never finished included, least
// recently used first.
struct Kept {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t bytes = 0;
};

std::vector<Kept> kept_files(const fs::path& folder) {
  std::vector<Kept> files;
  std::error_code fault;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end;
       at.increment(fault)) {
    const std::string name = at->path().filename().string();
    if (name.find(ending) == std::string::npos) continue;
    std::error_code gone;
    Kept file{at->path(), at->last_write_time(gone), 0};
    file.bytes = at->file_size(gone);
    if (!gone) files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &Kept::used);
  return files;
}

void make_room(const MatrixCache& cache, std::uintmax_t bytes) {
  const std::vector<Kept> files = kept_files(cache.folder);
  std::uintmax_t all = bytes;
  for (const Kept& file : files) all += file.bytes;
  for (const Kept& file : files) {
    if (all <= cache.limit) return;
    std::error_code fault;
    if (fs::remove(file.path, fault)) all -= file.bytes;
  }
}

// Whether the file and as much again fit on the disk.
bool fits(const fs::path& folder, std::uintmax_t bytes) {
  std::error_code fault;
  const fs::space_info space = fs::space(folder, fault);
  return !fault && space.available / 2 > bytes;
}

}  // namespace

std::optional<std::vector<MatrixXd>> MatrixCache::load(
    const Digest& key) const {
  const fs::path path = file_of(*this, key);
  std::error_code fault;
  const std::uintmax_t length = fs::file_size(path, fault);
  if (fault) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  Head head;
  if (!read(file, &head, 1)) return std::nullopt;
  Head expected;
  expected.key = key;
  expected.content = head.content;
  expected.matrices = head.matrices;
  if (head != expected) return std::nullopt;
  std::optional<std::vector<MatrixXd>> matrices =
      read_matrices(file, head, length);
  if (matrices) {
    fs::last_write_time(path, fs::file_time_type::clock::now(), fault);
  }
  return matrices;
}

bool MatrixCache::store(const Digest& key,
                        const std::vector<MatrixXd>& matrices) const {
  Sizes sizes;
  for (const MatrixXd& matrix : matrices) {
    sizes.push_back({matrix.rows(), matrix.cols()});
  }
  const std::optional<std::uintmax_t> length = length_of(sizes);
  if (!length || *length > limit || sizes.size() > most_matrices) return false;
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault || !fits(folder, *length)) return false;
  make_room(*this, *length);
  Head head;
  head.key = key;
  head.content = content_of(sizes, matrices);
  head.matrices = sizes.size();
  try {
    write_matrices(file_of(*this, key), head, sizes, matrices);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::optional<MatrixCache> user_cache() {
  const auto folder = acquisition::cache_folder();
  return folder ? std::optional(MatrixCache{*folder}) : std::nullopt;
}

}  // namespace tapfit::updating
