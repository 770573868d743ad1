// The field "geometry" of a test.json.
#pragma once

#include "acquisition/bundle/json_source.hpp"
#include "acquisition/bundle/test_bundle.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tapfit::acquisition {

/// @param entry of the schema's form; without a file the points are those of
///   the ready FRFs' universal file
/// @param bundle with its units and the file of its FRFs
/// @throws InputError for a file that is not there or holds no points, a pair
///   that names no point, or a point twice
[[nodiscard]] TestGeometry read_test_geometry(const nlohmann::json& entry,
                                              const TestBundle& bundle,
                                              const JsonSource& source);

/// The points of the test's own in a file of ready FRFs: of a test's geometry
/// all points, without one those with axes of their own.
/// @param bundle with its geometry and the file of its FRFs
[[nodiscard]] std::vector<TestPoint> points_of_frfs(const TestBundle& bundle);

}  // namespace tapfit::acquisition
