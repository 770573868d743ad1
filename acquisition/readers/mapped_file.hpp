// A file's bytes without reading them all into memory.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <filesystem>
#include <string_view>

namespace tapfit::acquisition {

/// A file mapped for reading; the operating system brings in the parts that
/// are looked at, so that files larger than memory can be searched.
class MappedFile {
 public:
  /// @throws InputError for a file that is missing or cannot be read
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// All bytes; valid as long as this object (and what it was moved into). Of a
  /// file that has become shorter meanwhile the rest is zeros: read it within
  /// reading().
  [[nodiscard]] std::string_view text() const { return text_; }

  /// Gives back the memory that a part of the text takes; read again, it comes
  /// from the file again.
  void forget(std::string_view part) const;

  /// What `read` returns of the text.
  /// @throws InputError for a file that has become shorter since it was
  ///   opened, whatever `read` made of that
  template <typename Read>
  auto reading(Read read) const {
    try {
      auto result = read();
      refuse_shortened();
      return result;
    } catch (...) {
      refuse_shortened();
      throw;
    }
  }

 private:
  void refuse_shortened() const;

  std::filesystem::path file_;
  int handle_ = -1;
  unsigned lost_pages_ = 0;  ///< of all mapped files, when it was opened
  std::string_view text_;
};

}  // namespace tapfit::acquisition
