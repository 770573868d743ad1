#include "updating/virtual_test/made_files.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr std::uint64_t fnv_basis = 14695981039346656037ULL;

std::uint64_t fnv(std::string_view bytes, std::uint64_t hash = fnv_basis) {
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  }
  return hash;
}

std::string as_hex(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

// Of all that the document holds but for the list.
std::string checksum_of(const json& truth) {
  return checksum_text(truth.dump());
}

json read_truth(const fs::path& folder) {
  try {
    return json::parse(
        acquisition::read_input(folder / truth_file), nullptr, false);
  } catch (const InputError&) {
    return nullptr;
  }
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) { return fnv(bytes); }

std::string checksum_text(std::string_view bytes) {
  return as_hex(checksum(bytes));
}

std::string checksum_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 1U << 16U> part{};
  std::uint64_t hash = fnv_basis;
  while (in.read(part.data(), part.size()), in.gcount() > 0) {
    hash = fnv({part.data(), static_cast<std::size_t>(in.gcount())}, hash);
  }
  return as_hex(hash);
}

json file_checksums(const fs::path& folder) {
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  json list = json::object();
  for (const fs::path& name : names) {
    list[name.string()] = checksum_of_file(folder / name);
  }
  return list;
}

void list_made_files(const fs::path& folder, json& truth) {
  json list = {{truth_file, checksum_of(truth)}};
  list.update(file_checksums(folder));
  truth["files"] = list;
}

std::vector<fs::path> made_files(const fs::path& folder) {
  json truth = read_truth(folder);
  if (!truth.is_object() || !truth.contains("files")) return {};
  const json list = truth.at("files");
  truth.erase("files");
  if (!list.is_object() ||
      list.value(truth_file, json()) != checksum_of(truth)) {
    return {};
  }
  std::vector<fs::path> made{folder / truth_file};
  for (const auto& [name, sum] : list.items()) {
    const fs::path file = folder / fs::path(name).filename();
    std::error_code none;
    if (name == truth_file || !fs::is_regular_file(file, none)) continue;
    if (sum == checksum_of_file(file)) made.push_back(file);
  }
  return made;
}

}  // namespace tapfit::updating
