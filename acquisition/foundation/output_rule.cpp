#include "acquisition/foundation/output_rule.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

// Empty where the path says nothing.
fs::path resolved(const fs::path& file) {
  std::error_code fault;
  const fs::path from_root = fs::absolute(file, fault);
  if (fault) return {};
  const fs::path result = fs::weakly_canonical(from_root, fault);
  return fault ? fs::path() : result;
}

// Of files that are not there the names decide.
bool same_file(const fs::path& one, const fs::path& other) {
  std::error_code fault;
  const bool there = fs::exists(one, fault);
  if (fs::exists(other, fault) != there) return false;
  if (there) return fs::equivalent(one, other, fault);
  const fs::path a = resolved(one);
  return !a.empty() && a == resolved(other);
}

// Before the work is done that is to be written there.
void check_names_file(const fs::path& output) {
  std::error_code fault;
  if (!output.has_filename() || fs::is_directory(output, fault)) {
    throw InputError("names no file that could be written",
                     fmt::format("\"{}\"", output.string()),
                     "give the name of a file");
  }
  // Standard output may be one; a name is waited at until something reads it.
  const std::string from_root = fs::absolute(output, fault).string();
  const bool own =
      from_root.starts_with("/dev/") || from_root.starts_with("/proc/");
  if (fs::is_fifo(output, fault) && !own) {
    throw InputError("is a pipe", output.string(), "give the name of a file");
  }
  const fs::path folder = output.parent_path();
  if (folder.empty() || fs::is_directory(folder, fault)) return;
  throw InputError(fs::exists(folder, fault)
                       ? "cannot be written: its folder is a file"
                       : "cannot be written: its folder is not there",
                   output.string(),
                   "make the folder, or name another");
}

}  // namespace

bool would_be_replaced(const fs::path& output) {
  std::error_code fault;
  const fs::file_status there = fs::status(output, fault);
  const bool is_link = fs::is_symlink(fs::symlink_status(output, fault));
  return fs::is_regular_file(there) || (is_link && !fs::exists(there));
}

bool OutputRule::is_input(const fs::path& output) const {
  return std::ranges::any_of(inputs, [&output](const fs::path& input) {
    return same_file(input, output);
  });
}

fs::path OutputRule::free_name(
    const fs::path& output,
    const std::function<bool(const fs::path&)>& also) const {
  const auto is_free = [&](const fs::path& name) {
    std::error_code fault;
    return !fs::exists(fs::symlink_status(name, fault)) && !is_input(name) &&
           (!also || also(name));
  };
  fs::path free = output;
  for (int k = 2; !is_free(free); ++k) {
    free = output.parent_path() / fmt::format("{}-{}{}",
                                              output.stem().string(),
                                              k,
                                              output.extension().string());
  }
  return free;
}

void OutputRule::check(const fs::path& output,
                       const std::string& instead) const {
  if (is_input(output)) {
    throw InputError("is an input of the test and is never written over",
                     output.string(),
                     instead);
  }
  if (force || !would_be_replaced(output)) return;
  throw InputError("is there already",
                   output.string(),
                   instead + ", or replace it with --force");
}

void OutputRule::check(const fs::path& output) const {
  check(output,
        fmt::format("give another name, such as {}",
                    free_name(output).filename().string()));
}

void OutputRule::check(const std::vector<fs::path>& outputs) const {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    check_names_file(outputs[k]);
    check(outputs[k]);
    for (std::size_t i = 0; i < k; ++i) {
      if (!same_file(outputs[i], outputs[k])) continue;
      throw InputError("is named for two outputs",
                       outputs[k].string(),
                       "give each a file of its own");
    }
  }
}

}  // namespace tapfit::acquisition
