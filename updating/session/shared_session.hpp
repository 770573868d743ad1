// The file of a session that several windows may have open: each takes over
// what the others did before it goes on, and none writes over what it has not
// seen.
#pragma once

#include "updating/session/saved_session.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tapfit::updating {

class SharedSession {
 public:
  /// @param file that may not be there yet
  explicit SharedSession(std::filesystem::path file);

  /// What stands in the file, where that is not what was read or written here
  /// last; it counts as seen from then on.
  /// @throws InputError as of read_saved_session()
  [[nodiscard]] std::optional<SavedSession> news();

  /// Writes the session, or takes the file away where it is empty.
  /// @return false where the file holds what was not seen: nothing was written
  /// @throws InputError where it cannot be written
  [[nodiscard]] bool write(const SavedSession& session);

 private:
  [[nodiscard]] bool has_news() const;

  std::filesystem::path file_;
  std::string seen_;  ///< its text
};

}  // namespace tapfit::updating
