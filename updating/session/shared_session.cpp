#include "updating/session/shared_session.hpp"

#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/output_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace tapfit::updating {
namespace {

/// Keeps other windows from writing in the folder while it lives. Where the
/// file system knows no locks there is none.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
  }
  ~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace

SharedSession::SharedSession(std::filesystem::path file)
    : file_(std::move(file)) {}

// A file that was taken away tells nothing new.
bool SharedSession::has_news() const {
  const std::string text = acquisition::read_input(file_);
  return !text.empty() && text != seen_;
}

std::optional<SavedSession> SharedSession::news() {
  if (!has_news()) return std::nullopt;
  const FolderLock lock(file_.parent_path());
  SavedSession session = read_saved_session(file_);
  seen_ = acquisition::read_input(file_);
  return session;
}

bool SharedSession::write(const SavedSession& session) {
  const FolderLock lock(file_.parent_path());
  if (has_news()) return false;
  if (session.empty()) {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    seen_.clear();
    return true;
  }
  std::string text = as_text(session);
  acquisition::write_file(file_, text, {{}, true});
  seen_ = std::move(text);
  return true;
}

}  // namespace tapfit::updating
