#include "updating/export/outside_files.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

// The path itself where there is no such file.
fs::path resolved(const fs::path& path) {
  std::error_code fault;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), fault);
  return fault ? path : whole;
}

std::vector<fs::path> outside(const fs::path& folder,
                              const std::vector<fs::path>& files) {
  const fs::path root = resolved(folder.empty() ? "." : folder);
  std::vector<fs::path> result;
  for (const fs::path& file : files) {
    const fs::path whole = resolved(file);
    const auto [at_root, at_file] = std::ranges::mismatch(root, whole);
    const bool within = at_root == root.end();
    if (within || std::ranges::count(result, whole) > 0) continue;
    result.push_back(whole);
  }
  return result;
}

bool is_deck(const fs::path& input) {
  std::error_code ignored;
  return fs::is_regular_file(input, ignored) && input.extension() != ".json" &&
         !acquisition::is_uff(input);
}

}  // namespace

std::vector<fs::path> outside_files(const acquisition::TestBundle& bundle) {
  return outside(bundle.folder, output_rule_of(bundle, false).inputs);
}

void check_inside(const fs::path& input) {
  const std::vector<fs::path> files =
      is_deck(input)
          ? outside(input.parent_path(), structure::deck_files(input))
          : outside_files(acquisition::read_test_bundle(input));
  if (files.empty()) return;
  std::string what = "reads from outside its folder: ";
  for (const fs::path& file : files) {
    what += (file == files.front() ? "" : ", ") + file.string();
  }
  throw InputError(what,
                   input.string(),
                   "copy these files into it and name them there, or leave "
                   "--inside out for a test that you trust");
}

}  // namespace tapfit::updating
