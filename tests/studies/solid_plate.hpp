// A plate twice: of quadratic solid elements, as it is, and of shells at their
// middle, as an engineer has it; or a frame, whose deck is of bars along the
// middles of its cells. The grids of the deck are grids of the solids with the
// same ids.
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

/// Cells of a lattice in u (columns) and v (rows), bent into its shape.
struct SolidPlate {
  std::string name;
  int columns = 1;
  int rows = 1;
  double pitch = 0.02;       ///< about, of a cell [m]
  double thickness = 0.004;  ///< [m]
  double E = 70e9;           ///< [N/m^2]
  double nu = 0.33;
  double density = 2700.0;  ///< [kg/m^3]
  /// Where the middle is for u, v from 0 to 1 [m].
  std::function<Eigen::Vector3d(double, double)> middle = {};
  /// Whether a cell is there; all, where empty.
  std::function<bool(int, int)> has_cell = {};
  /// Factor of the thickness of a cell, in the deck, too; 1, where empty.
  std::function<double(int, int)> thicker = {};
  /// Whether it is held at a grid of the lattice, counted from 0.
  std::function<bool(int, int)> is_held = {};
  std::array<double, 2> band_hz{10.0, 1000.0};
  int split = 4;   ///< solids along a side of a cell
  int layers = 2;  ///< of solids across
  /// Members one cell wide, of the pitch, each a row of bars in the deck.
  bool of_bars = false;
};

/// What the solids have and the shells do not.
struct HiddenInSolid {
  /// Cells, first and last column, first and last row, that are thinner.
  std::array<int, 4> pocket{1, 0, 1, 0};
  double left = 1.0;  ///< of the thickness there
  /// Between two columns of solids, their first, parted over rows of solids
  /// from the first, an edge, to the last; none where last is before first.
  std::array<int, 3> crack{0, 1, 0};
  /// Of the face that is held, on springs [N/m per m^2]; 0: it is held.
  double bed = 0.0;
};

/// Of shells or of bars.
[[nodiscard]] std::string engineers_deck(const SolidPlate& plate);
[[nodiscard]] std::string solid_deck(const SolidPlate& plate,
                                     const HiddenInSolid& hidden);
/// Of the engineer's deck: at a corner of a cell, or of bars in its middle.
[[nodiscard]] int grid_id(const SolidPlate& plate, int column, int row);
[[nodiscard]] Eigen::Vector3d place_of(const SolidPlate& plate,
                                       double column,
                                       double row);

}  // namespace tapfit::updating::testing
