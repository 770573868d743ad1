// The test's own points for a universal file: their places and axes.
#pragma once

#include "acquisition/uff/uff_geometry.hpp"
#include "updating/session/session.hpp"

namespace tapfit::updating {

/// Nodes with displacement systems of their own, labelled as uff_label says. On
/// the model where there is one; else as test.json says them, without their
/// heights and without those that only a model places. Nothing where the test
/// has no such points.
[[nodiscard]] acquisition::UffGeometry point_geometry(Session& session);

}  // namespace tapfit::updating
