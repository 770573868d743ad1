#include "acquisition/readers/mapped_file.hpp"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace tapfit::acquisition {
namespace {

std::uintptr_t page_size() {
  static const auto size = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  return size;
}

// A signal handler reaches only what is global.
std::atomic<unsigned> lost_pages = 0;

// A page that the file has no content for any more is answered with SIGBUS.
// Zeros take its place, so that whoever reads comes to an end.
extern "C" void on_lost_page(int /*signal*/,
                             siginfo_t* info,
                             void* /*context*/) {
  const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
  void* page = reinterpret_cast<void*>(at / page_size() * page_size());
  constexpr int how = MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED;
  if (info->si_code == BUS_ADRERR &&
      ::mmap(page, page_size(), PROT_READ, how, -1, 0) != MAP_FAILED) {
    ++lost_pages;
    return;
  }
  std::abort();  // which a terminal takes to be put right
}

void watch_lost_pages() {
  static const bool watched = [] {
    (void)page_size();  // asked for before it is needed in the handler
    struct sigaction action {};
    action.sa_sigaction = on_lost_page;
    action.sa_flags = SA_SIGINFO;
    return ::sigaction(SIGBUS, &action, nullptr) == 0;
  }();
  (void)watched;
}

InputError unreadable(const std::filesystem::path& file) {
  return {"the file cannot be read",
          file.string(),
          "check its name and your rights to it"};
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& file) : file_(file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) throw unreadable(file);
  watch_lost_pages();
  lost_pages_ = lost_pages;
  handle_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat there {};
  if (handle_ < 0) throw unreadable(file);
  void* bytes = nullptr;
  std::size_t size = 0;
  if (::fstat(handle_, &there) == 0) {
    size = static_cast<std::size_t>(there.st_size);
    if (size == 0) return;
    bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, handle_, 0);
  }
  if (bytes == nullptr || bytes == MAP_FAILED) {
    ::close(handle_);
    throw unreadable(file);
  }
  // Read ahead further than usual; what it answers does not matter.
  (void)::madvise(bytes, size, MADV_SEQUENTIAL);
  text_ = {static_cast<const char*>(bytes), size};
}

MappedFile::~MappedFile() {
  if (handle_ >= 0) ::close(handle_);
  if (text_.empty()) return;
  ::munmap(const_cast<char*>(text_.data()), text_.size());
}

void MappedFile::forget(std::string_view part) const {
  // Whole pages that lie in the part; those at its ends may be in use.
  const std::size_t page = page_size();
  const auto begin = static_cast<std::size_t>(part.data() - text_.data());
  const std::size_t first = (begin + page - 1) / page * page;
  const std::size_t last = (begin + part.size()) / page * page;
  if (last <= first) return;
  // Only a hint, and of a mapping that is never written to.
  (void)::madvise(
      const_cast<char*>(text_.data()) + first, last - first, MADV_DONTNEED);
}

// The size tells what is gone now, the pages what was gone for a while; the
// latter may have been another file's, which then is refused as well.
void MappedFile::refuse_shortened() const {
  struct stat now {};
  const bool whole = ::fstat(handle_, &now) == 0 &&
                     static_cast<std::size_t>(now.st_size) >= text_.size();
  if (whole && lost_pages == lost_pages_) return;
  throw InputError("became shorter while it was read",
                   file_.string(),
                   "wait until it is written, or copy it again");
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : file_(std::move(other.file_)),
      handle_(std::exchange(other.handle_, -1)),
      lost_pages_(other.lost_pages_),
      text_(std::exchange(other.text_, {})) {}

}  // namespace tapfit::acquisition
