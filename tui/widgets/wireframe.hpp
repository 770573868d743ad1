// A deck's lines, projected: the structure as one sees it.
#pragma once

#include "acquisition/bundle/test_geometry.hpp"
#include "tui/screen/key.hpp"
#include "tui/screen/screen.hpp"
#include "tui/widgets/scene.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace tapfit::tui {

/// Every edge once: of shells, bars, rods, plot lines. Of meshes with more
/// than 3000 edges only those that belong to one shell (the outline), to
/// bars, rods and plot lines.
[[nodiscard]] Wireframe wireframe(const structure::Deck& deck);

/// The points of a test that has no model, without lines, under their labels
/// and under the node (-label) of measured degrees of freedom there.
[[nodiscard]] Wireframe wireframe(const acquisition::TestGeometry& geometry);

struct Pose {
  double azimuth_deg = -35.0;
  double elevation_deg = 35.0;
  double zoom = 1.0;
};

/// Displacements of single nodes along basic axes.
[[nodiscard]] std::map<int, Eigen::Vector3d> along_basic(
    const Wireframe& wire, std::map<int, Eigen::Vector3d> of_nodes);

/// `<` `>` and `,` `.` turn, `(` `)` tilt, `{` `}` zoom.
bool pose_key(Pose& pose, Key key);

/// Fitted into the rectangle, the cells' 1:2 shape allowed for. The largest
/// displacement is drawn as an eighth of the structure's size. Of a mesh whose
/// lines would run into each other only so many are drawn that they do not;
/// under a shape, of the structure at rest only the outline.
void draw_wireframe(Screen& screen,
                    const Rect& rect,
                    const Wireframe& wire,
                    const Scene& scene,
                    const Pose& pose);

}  // namespace tapfit::tui
