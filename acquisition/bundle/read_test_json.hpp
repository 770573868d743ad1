// test.json before anything that it names is looked at: JSON syntax
// (nlohmann-json), form (JSON Schema), and the files it names.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace tapfit::acquisition {

/// FOLDER/test.json, or the file itself that is given in its place.
[[nodiscard]] std::filesystem::path test_json_of(
    const std::filesystem::path& bundle);

/// @param file as test_json_of
/// @throws InputError with line and column for what is no JSON, with the
///   field's place for what the schema does not allow
[[nodiscard]] nlohmann::json read_test_json(const std::filesystem::path& file);

/// A bundle of nothing but its paths, of which test.json alone is opened; of a
/// universal file that is a bundle by itself only its beginning is.
/// @throws InputError as read_test_json
[[nodiscard]] TestBundle read_bundle_paths(const std::filesystem::path& bundle);

}  // namespace tapfit::acquisition
