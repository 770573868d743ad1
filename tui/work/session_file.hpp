// Where the work on a bundle is kept.
#pragma once

#include <filesystem>

namespace tapfit::tui {

/// session.json in the bundle's folder; for a bundle that is a single file
/// other than test.json, FILE.session.json beside it.
[[nodiscard]] inline std::filesystem::path session_file(
    const std::filesystem::path& bundle) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(bundle, ignored)) {
    return bundle / "session.json";
  }
  if (bundle.filename() == "test.json") {
    return bundle.parent_path() / "session.json";
  }
  std::filesystem::path beside = bundle;
  beside += ".session.json";
  return beside;
}

}  // namespace tapfit::tui
