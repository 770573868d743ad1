// Where the work on a bundle is kept.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>

namespace tapfit::updating {

/// session.json in the bundle's folder; for a bundle that is a file of another
/// name than test.json, FILE.session.json beside it.
[[nodiscard]] inline std::filesystem::path session_file(
    const acquisition::TestBundle& bundle) {
  if (bundle.file.filename() == "test.json") {
    return bundle.folder / "session.json";
  }
  std::filesystem::path beside = bundle.file;
  beside += ".session.json";
  return beside;
}

}  // namespace tapfit::updating
