// The truth of a virtual test as a seal: packed, so that nobody reads it by
// accident, and with the checksums of the files that it is the truth of. It is
// a seal and no secret: whoever wants to open it can, and the same seed makes
// the same test again.
//
//   sealed.json: {"tapfit_seal": 1, "note": "...", "files": {NAME: CHECKSUM},
//                 "truth": PACKED, "checksum": ...}
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace tapfit::updating {

inline constexpr const char* seal_file = "sealed.json";

/// The seal's text.
/// @param truth as in truth.json
/// @param folder of the finished test, but for the seal
[[nodiscard]] std::string sealed_text(const nlohmann::ordered_json& truth,
                                      const std::filesystem::path& folder);

/// The truth of the test in a folder.
/// @throws InputError where there is no seal, where it is damaged, and where a
///   file that it belongs to is missing or another one
[[nodiscard]] nlohmann::ordered_json open_seal(
    const std::filesystem::path& folder);

}  // namespace tapfit::updating
