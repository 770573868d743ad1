#include "updating/virtual_test/truth_seal.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/seeded_random.hpp"
#include "updating/virtual_test/made_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cstddef>
#include <optional>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

// Every byte turned by one of a stream that the sealed files give; again, and
// it is as it was.
std::string turned(std::string bytes, const json& files) {
  acquisition::SeededRandom random(checksum(files.dump()), "seal");
  for (char& byte : bytes) {
    const auto key = static_cast<unsigned>(random.uniform(0.0, 256.0));
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ key);
  }
  return bytes;
}

std::string as_digits(const std::string& bytes) {
  std::string digits;
  for (const char byte : bytes) {
    digits += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  }
  return digits;
}

std::optional<std::string> from_digits(const std::string& digits) {
  if (digits.size() % 2 != 0) return std::nullopt;
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2) {
    unsigned value = 0;
    const char* begin = digits.data() + k;
    const auto [stop, error] = std::from_chars(begin, begin + 2, value, 16);
    if (error != std::errc() || stop != begin + 2) return std::nullopt;
    bytes += static_cast<char>(value);
  }
  return bytes;
}

std::string sum_of(const std::string& truth, const json& files) {
  return checksum_text(truth + files.dump());
}

// The truth as it was packed; nothing where the seal is not as it was written.
std::optional<json> unpacked(const json& seal) {
  if (!seal.is_object() || seal.value("tapfit_seal", 0) != 1) return {};
  const json files = seal.value("files", json());
  const json packed = seal.value("truth", json());
  if (!files.is_object() || !packed.is_string()) return {};
  const auto bytes = from_digits(packed.get<std::string>());
  if (!bytes) return {};
  const std::string text = turned(*bytes, files);
  if (seal.value("checksum", json()) != sum_of(text, files)) return {};
  const json truth = json::parse(text, nullptr, false);
  return truth.is_object() ? std::optional(truth) : std::nullopt;
}

void check_sealed(const json& files, const fs::path& folder) {
  for (const auto& [name, sum] : files.items()) {
    const fs::path file = folder / fs::path(name).filename();
    std::error_code none;
    const bool there = fs::is_regular_file(file, none);
    if (there && sum == checksum_of_file(file)) continue;
    throw InputError(
        fmt::format("the seal belongs to another test: {} {}",
                    name,
                    there ? "is not the file that was sealed" : "is missing"),
        (folder / seal_file).string(),
        "put the file back as it was made, or make the challenge again in a "
        "new folder: the same seed gives the same test");
  }
}

}  // namespace

std::string sealed_text(const json& truth, const fs::path& folder) {
  const json files = file_checksums(folder);
  const std::string text = truth.dump();
  const json seal{
      {"tapfit_seal", 1},
      {"note",
       "What is hidden in this test, packed so that it is not read by "
       "accident. tapfit reveal opens it."},
      {"files", files},
      {"truth", as_digits(turned(text, files))},
      {"checksum", sum_of(text, files)}};
  return seal.dump(1) + '\n';
}

json open_seal(const fs::path& folder) {
  const fs::path file = folder / seal_file;
  std::error_code none;
  if (!fs::exists(file, none)) {
    throw InputError("there is no seal: this is no challenge",
                     file.string(),
                     "name the folder that tapfit challenge made");
  }
  const json seal = json::parse(acquisition::read_input(file), nullptr, false);
  std::optional<json> truth;
  try {
    truth = unpacked(seal);
  } catch (const json::exception&) {
    // A field of another type than it was written with.
  }
  if (!truth) {
    throw InputError("the seal is damaged",
                     file.string(),
                     "make the challenge again in a new folder: the same seed "
                     "gives the same test");
  }
  check_sealed(seal.at("files"), folder);
  return *truth;
}

}  // namespace tapfit::updating
