// A clamped strip, small enough to be looked at whole, as a virtual structure.
#pragma once

#include "updating/virtual_test/virtual_panel.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tapfit::updating::support {

/// A clamped strip, 0.30 m x 0.04 m x 2 mm.
inline Panel strip() {
  Panel panel;
  panel.x = {{0.30, 10}};
  panel.y = {{0.04, 2}};
  panel.fields = {"#"};
  panel.thickness = 0.002;
  panel.clamped = true;
  return panel;
}

inline VirtualModel model_of(const Panel& panel, int split) {
  PanelMesh fine = mesh_panel(panel, split);
  return {mesh_panel(panel, 1).deck, fine.deck, fine.children};
}

inline int grid_at(const structure::Deck& deck, double x, double y) {
  for (const structure::Grid& grid : deck.grids) {
    if ((grid.position - Eigen::Vector3d(x, y, 0.0)).norm() < 1e-9) {
      return grid.id;
    }
  }
  ADD_FAILURE() << "no grid at " << x << ", " << y;
  return 0;
}

/// The strip with a sensor at one tip corner, hit at the other.
struct Strip {
  VirtualModel model = model_of(strip(), 2);
  Dof corner{grid_at(model.model, 0.30, 0.0), 3, 1};
  Dof other{grid_at(model.model, 0.30, 0.04), 3, 1};
  std::vector<VirtualSensor> sensors{{"acc1", corner}};

  [[nodiscard]] ReducedTruth reduced(const std::vector<std::string>& texts,
                                     double damping = 0.005,
                                     double max_hz = 600.0) const {
    std::vector<VirtualEffect> effects;
    for (const std::string& text : texts) {
      effects.push_back(parse_virtual_effect(text));
    }
    VirtualDamping law;
    law.mean = damping;
    return reduce_truth(build_virtual_structure(model, effects, 1.0, 3),
                        sensors,
                        {other, corner},
                        max_hz,
                        law);
  }
};

}  // namespace tapfit::updating::support
