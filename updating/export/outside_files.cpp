#include "updating/export/outside_files.hpp"

#include "acquisition/bundle/read_test_json.hpp"
#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
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

bool is_within(const fs::path& folder, const fs::path& file) {
  const fs::path root = resolved(folder.empty() ? "." : folder);
  return std::ranges::mismatch(root, resolved(file)).in1 == root.end();
}

std::vector<fs::path> outside(const fs::path& folder,
                              const std::vector<fs::path>& files) {
  std::vector<fs::path> result;
  for (const fs::path& file : files) {
    const fs::path whole = resolved(file);
    if (is_within(folder, file) || std::ranges::count(result, whole) > 0) {
      continue;
    }
    result.push_back(whole);
  }
  return result;
}

std::vector<std::string> texts_of(const std::vector<fs::path>& files) {
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(file.string());
  return texts;
}

bool is_deck(const fs::path& input) {
  std::error_code ignored;
  return fs::is_regular_file(input, ignored) && input.extension() != ".json" &&
         !acquisition::is_uff(input);
}

}  // namespace

std::vector<fs::path> outside_files(const acquisition::TestBundle& bundle) {
  return outside(bundle.folder, inputs_of(bundle));
}

void check_inside(const fs::path& input) {
  const fs::path main =
      is_deck(input) ? input : acquisition::test_json_of(input);
  const fs::path folder = main.parent_path();
  const auto refuse_outside = [&](const std::vector<fs::path>& named) {
    const std::vector<fs::path> files = outside(folder, named);
    if (files.empty()) return;
    throw InputError(fmt::format("reads from outside its folder: {}",
                                 fmt::join(texts_of(files), ", ")),
                     input.string(),
                     "copy these files into it and name them there, or leave "
                     "--inside out for a test that you trust");
  };
  const auto within = [&](const fs::path& file) {
    return is_within(folder, file);
  };
  refuse_outside({main});
  refuse_outside(
      is_deck(input)
          ? structure::deck_files(input, within)
          : inputs_of(acquisition::read_bundle_paths(input), within));
}

}  // namespace tapfit::updating
