// Files that appear whole or not at all. What is written stands beside its
// target under another name, and takes the target's place when it is done: a
// full disk, a fault or a request to stop leaves the older file, or none.
#pragma once

#include "acquisition/foundation/output_rule.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::acquisition {

/// One file. Links are followed; what is no regular file (a pipe, /dev/null)
/// is written to as it is. The rule is asked when it is opened and again before
/// it takes its place: others may have come between.
class OutputFile {
 public:
  /// @throws InputError where the rule does not let it, or nothing can be
  ///   written
  OutputFile(const std::filesystem::path& target, OutputRule rule);
  /// Takes away what was not committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// Closes the file, which is when the system reports a full disk at the
  /// latest; commit() then has only its name to change. For files that belong
  /// together.
  /// @throws InputError where something could not be written
  void finish();

  /// Finishes the file and puts it in its place; to be called once, at the end.
  /// @throws InputError where the rule does not let it any more, or something
  ///   could not be written
  void commit();

 private:
  std::filesystem::path target_;
  OutputRule rule_;
  std::filesystem::path unfinished_;  ///< empty: nothing to take away
  std::ofstream stream_;
};

/// Several files that belong together. Those that are in the folder already
/// are its rule's to decide on, file by file; none is taken away.
class OutputFolder {
 public:
  /// @param target made by commit() when it is not there
  /// @throws InputError where nothing can be written
  OutputFolder(const std::filesystem::path& target, OutputRule rule);
  /// Takes away what was not committed.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file that commit() brings into the folder.
  /// @param name without a folder
  /// @param writer is told where it stands till then; its InputError is thrown
  ///   with the file's own name in it
  /// @throws InputError where the rule does not let it
  void write(
      const std::filesystem::path& name,
      const std::function<void(const std::filesystem::path&)>& writer) const;
  /// A whole file at once.
  void write(const std::filesystem::path& name, std::string_view content) const;

  /// Brings all files into the folder, over older ones of their names where the
  /// rule lets all of them, else none.
  /// @throws InputError where it does not, or where that fails
  void commit();

 private:
  std::filesystem::path target_;
  OutputRule rule_;
  std::filesystem::path unfinished_;
};

/// Before a folder is written that takes long to make.
/// @throws InputError where the rule does not let a file of that name into it,
///   or what has that name is no file that can be replaced
void check_in_folder(const OutputRule& rule,
                     const std::filesystem::path& folder,
                     const std::filesystem::path& name);

/// A whole file at once.
/// @throws InputError where the rule does not let it, or it cannot be written
void write_file(const std::filesystem::path& target,
                std::string_view content,
                const OutputRule& rule);

/// A file and what it is to hold.
struct FileContent {
  std::filesystem::path path;
  std::string content;
};

/// Files that belong together, all of them or none.
/// @param files of one folder, which is there
/// @throws InputError where the rule does not let one of them, or one cannot be
///   written
void write_files(const std::vector<FileContent>& files, const OutputRule& rule);

}  // namespace tapfit::acquisition
