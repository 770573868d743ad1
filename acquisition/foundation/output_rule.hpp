// What may be written where: never over an input, over another file only where
// that is asked for.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Whether writing there would replace what is there: a file, or a link, which
/// is someone's name for a file, whether that is there or not. Neither a pipe
/// nor a device is replaced by writing to it.
[[nodiscard]] bool would_be_replaced(const std::filesystem::path& output);

struct OutputRule {
  /// What was read, and must never be written. Need not be there.
  std::vector<std::filesystem::path> inputs;
  bool force = false;  ///< other files that are there may be replaced

  /// Whether the path leads to an input, by whatever name or link.
  [[nodiscard]] bool is_input(const std::filesystem::path& output) const;

  /// The first of NAME.EXT, NAME-2.EXT, NAME-3.EXT, ... that is neither an
  /// input nor there.
  /// @param also what else is asked of it; empty: nothing
  [[nodiscard]] std::filesystem::path free_name(
      const std::filesystem::path& output,
      const std::function<bool(const std::filesystem::path&)>& also = {}) const;

  /// @throws InputError for an input, for a file that is there without
  ///   `force`; names one that is free
  void check(const std::filesystem::path& output) const;

  /// As above.
  /// @param instead what can be done but for --force, for the message
  void check(const std::filesystem::path& output,
             const std::string& instead) const;

  /// As above for each, that no file is named twice, and that each is the name
  /// of a file in a folder that is there.
  void check(const std::vector<std::filesystem::path>& outputs) const;
};

}  // namespace tapfit::acquisition
