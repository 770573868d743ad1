#include "tui/app/recent_bundles.hpp"

#include "acquisition/foundation/cache_folder.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_kept = 12;

std::optional<fs::path> list_file() {
  const auto folder = acquisition::cache_folder();
  if (!folder) return std::nullopt;
  const fs::path file = *folder / "recent-bundles";
  std::error_code fault;
  const bool other = fs::exists(file, fault) && !fs::is_regular_file(file);
  return other ? std::nullopt : std::optional(file);
}

/// Those that were opened, there or not.
std::vector<fs::path> listed_bundles() {
  std::vector<fs::path> bundles;
  const auto file = list_file();
  if (!file) return bundles;
  std::ifstream lines(*file);
  for (std::string line; std::getline(lines, line);) {
    if (bundles.size() < most_kept) bundles.emplace_back(line);
  }
  return bundles;
}

}  // namespace

std::vector<fs::path> recent_bundles() {
  std::vector<fs::path> bundles = listed_bundles();
  std::erase_if(bundles, [](const fs::path& bundle) {
    std::error_code fault;
    return !bundle.is_absolute() || !fs::exists(bundle, fault);
  });
  return bundles;
}

void remember_bundle(const fs::path& bundle) {
  const auto file = list_file();
  std::error_code fault;
  const fs::path opened = fs::weakly_canonical(bundle, fault);
  if (!file || fault || opened.string().find('\n') != std::string::npos) return;
  std::vector<fs::path> bundles = listed_bundles();
  std::erase(bundles, opened);
  bundles.insert(bundles.begin(), opened);
  bundles.resize(std::min(bundles.size(), most_kept));
  std::string text;
  for (const fs::path& one : bundles) text += one.string() + "\n";
  try {
    fs::create_directories(file->parent_path(), fault);
    acquisition::write_file(*file, text, {{}, true});
  } catch (const InputError&) {
    return;  // a full disk or a folder of others: the list is no work of theirs
  }
}

}  // namespace tapfit::tui
