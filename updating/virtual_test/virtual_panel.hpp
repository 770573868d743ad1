// Flat panels cut from a rectangular raster, as bulk data models of any mesh
// fineness: the structures of the virtual hammer test.
//
// x and y are divided into spans; a span of x and one of y make a field that
// is plate or hole. Strips, frames, ladders and plates are all of this kind.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>
#include <string>
#include <vector>

namespace tapfit::updating {

struct PanelSpan {
  double length = 0.0;  ///< [m]
  int elements = 1;     ///< of the engineer's model
};

struct Panel {
  std::string title;
  std::vector<PanelSpan> x;
  std::vector<PanelSpan> y;
  std::vector<std::string>
      fields;              ///< one text per x span; '#' plate, '.' hole
  double thickness = 0.0;  ///< [m]
  double E = 70e9;         ///< [Pa]
  double nu = 0.33;
  double rho = 2700.0;   ///< [kg/m^3]
  bool clamped = false;  ///< all grids at x = 0 held
};

/// A mesh of a panel. Grids and elements of the engineer's model (split = 1)
/// keep their ids in every finer one.
struct PanelMesh {
  structure::Deck deck;
  std::map<int, std::vector<int>> children;  ///< model element -> elements here
};

/// @param split elements along each side of a model element, at least 1
[[nodiscard]] PanelMesh mesh_panel(const Panel& panel, int split);

/// The mesh as Nastran bulk data, one card per text, free field.
[[nodiscard]] std::vector<std::string> panel_cards(const Panel& panel,
                                                   const PanelMesh& mesh);

/// Aluminium frame 0.90 m x 0.55 m of 60 mm x 3 mm strip with cross bars at
/// root, middle and tip, clamped at the root.
[[nodiscard]] Panel frame_panel();

/// Aluminium ladder 1.00 m x 0.28 m of 40 mm x 4 mm strip, five rungs,
/// clamped at the first.
[[nodiscard]] Panel ladder_panel();

/// Free aluminium plate 0.48 m x 0.32 m x 3 mm.
[[nodiscard]] Panel plate_panel();

}  // namespace tapfit::updating
