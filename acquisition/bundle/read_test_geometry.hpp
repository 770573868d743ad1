// The field "geometry" of a test.json.
#pragma once

#include "acquisition/bundle/json_source.hpp"
#include "acquisition/bundle/test_bundle.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace tapfit::acquisition {

/// @param entry of the schema's form; without a file the points are those of
///   the universal file of ready FRFs or modes
/// @param bundle with its units and the file of its FRFs or modes
/// @throws InputError for a file that is not there or holds no points, a pair
///   that names no point, or a point twice
[[nodiscard]] TestGeometry read_test_geometry(const nlohmann::json& entry,
                                              const TestBundle& bundle,
                                              const JsonSource& source);

/// The file of a bundle's ready FRFs or modes, which names the points.
[[nodiscard]] std::optional<std::filesystem::path> points_file(
    const TestBundle& bundle);

/// The points of the test's own in a file of ready FRFs or modes: of a test's
/// geometry all points, without one those with axes of their own.
/// @param path as of points_file()
/// @param bundle with its geometry
[[nodiscard]] std::vector<TestPoint> points_of_file(
    const std::filesystem::path& path, const TestBundle& bundle);

}  // namespace tapfit::acquisition
