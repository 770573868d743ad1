// Decks for the tests of updating/structure: from text, and meshed plates.
#pragma once

#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tapfit::structure {

/// Writes the text to a file of the test's own and returns its path.
inline std::filesystem::path write_text(const std::string& name,
                                        const std::string& text) {
  const ::testing::TestInfo* test =
      ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "tapfit_structure" /
      (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
  return folder / name;
}

inline Deck deck_of(const std::string& text) {
  return read_deck(write_text("model.bdf", text));
}

struct Plate {
  double a = 1.0;  ///< along x [m]
  double b = 1.0;  ///< along y [m]
  double thickness = 0.01;
  Material material{1, false, 200e9, 0.3, 200e9 / 2.6, 8000.0, 0, 0, 0};
  bool shear = true;
  bool triangles = false;
  bool coupled = true;
};

/// nx by ny elements in the plane z = 0; grid (i, j) has id 1 + i (ny + 1) + j.
inline Deck plate_deck(const Plate& plate, int nx, int ny) {
  Deck deck;
  deck.coupled_mass = plate.coupled;
  deck.materials[1] = plate.material;
  deck.shell_properties[1] = {1, 1, 1, plate.shear ? 1 : 0, plate.thickness};
  const auto id = [&](int i, int j) { return 1 + i * (ny + 1) + j; };
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      deck.grids.push_back(
          {id(i, j), {plate.a * i / nx, plate.b * j / ny, 0.0}});
    }
  }
  int next = 1;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const int p = id(i, j);
      const int q = id(i + 1, j);
      const int r = id(i + 1, j + 1);
      const int s = id(i, j + 1);
      if (!plate.triangles) {
        deck.shells.push_back({next++, 1, {p, q, r, s}});
      } else if ((i + j) % 2 == 0) {
        deck.shells.push_back({next++, 1, {p, q, r}});
        deck.shells.push_back({next++, 1, {p, r, s}});
      } else {
        deck.shells.push_back({next++, 1, {p, q, s}});
        deck.shells.push_back({next++, 1, {q, r, s}});
      }
    }
  }
  return deck;
}

inline Bar make_bar(int id, int property, int a, int b) {
  Bar bar;
  bar.id = id;
  bar.property = property;
  bar.grids = {a, b};
  bar.orientation = Eigen::Vector3d::UnitZ();
  return bar;
}

/// Holds components of every grid for which `where` is true.
template <typename Location>
void hold(Deck& deck, const std::string& components, const Location& where) {
  for (const Grid& grid : deck.grids) {
    if (where(grid.position)) {
      deck.constraints.push_back({grid.id, components});
    }
  }
}

inline SparseMatrix sparse(const Eigen::MatrixXd& A) { return A.sparseView(); }

inline Eigenmodes modes_of(const Deck& deck, Eigen::Index count) {
  const System system = assemble(deck);
  const FreeMotions motions = free_motions(system);
  return eigenmodes(motions.reduce(system.K), motions.reduce(system.M), count);
}

}  // namespace tapfit::structure
