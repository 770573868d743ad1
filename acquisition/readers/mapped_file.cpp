#include "acquisition/readers/mapped_file.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace tapfit::acquisition {
namespace {

InputError unreadable(const std::filesystem::path& file) {
  return {"the file cannot be read",
          file.string(),
          "check its name and your rights to it"};
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) throw unreadable(file);
  const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) throw unreadable(file);
  const auto size =
      static_cast<std::size_t>(std::filesystem::file_size(file, ignored));
  void* bytes = nullptr;
  if (!ignored && size > 0) {
    bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, handle, 0);
  }
  ::close(handle);
  if (ignored || bytes == MAP_FAILED) throw unreadable(file);
  // Read ahead further than usual; what it answers does not matter.
  if (size > 0) (void)::madvise(bytes, size, MADV_SEQUENTIAL);
  if (bytes != nullptr) text_ = {static_cast<const char*>(bytes), size};
}

MappedFile::~MappedFile() {
  if (text_.empty()) return;
  ::munmap(const_cast<char*>(text_.data()), text_.size());
}

void MappedFile::forget(std::string_view part) const {
  // Whole pages that lie in the part; those at its ends may be in use.
  static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = static_cast<std::size_t>(part.data() - text_.data());
  const std::size_t first = (begin + page - 1) / page * page;
  const std::size_t last = (begin + part.size()) / page * page;
  if (last <= first) return;
  // Only a hint, and of a mapping that is never written to.
  (void)::madvise(
      const_cast<char*>(text_.data()) + first, last - first, MADV_DONTNEED);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : text_(std::exchange(other.text_, {})) {}

}  // namespace tapfit::acquisition
