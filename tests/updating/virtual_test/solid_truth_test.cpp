#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;

// A steel strip of 200 x 20 x 4 mm, held at x = 0: a row of ten bricks whose
// corners stand 2 mm off the ten bars in its middle. Grids of the bars are in
// the middle of the bricks' upright edges, at y = 0.
std::string bar_deck() {
  std::string text = "SPC = 1\nBEGIN BULK\n";
  for (int k = 0; k <= 10; ++k) {
    text += fmt::format("GRID,{},,{},0.,0.\n", k + 1, 0.02 * k);
  }
  for (int k = 1; k <= 10; ++k) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", k, k, k + 1);
  }
  return text +
         "PBAR,1,1,8.0-5,2.6667-9,1.0667-10,3.7-10\n"
         "MAT1,1,2.1+11,,.3,7850.\n"
         "SPC1,1,123456,1\nENDDATA\n";
}

std::string brick_deck() {
  std::string text = "SPC = 1\nBEGIN BULK\n";
  const auto node = [](int a, int b, int c) {
    const bool bar = a % 2 == 0 && b == 0 && c == 1;
    return bar ? a / 2 + 1 : 1000 + 100 * a + 10 * b + c;
  };
  for (int a = 0; a <= 20; ++a) {
    for (int b = 0; b <= 2; ++b) {
      for (int c = 0; c <= 2; ++c) {
        if (a % 2 + b % 2 + c % 2 > 1) continue;
        text += fmt::format("GRID,{},,{},{},{}\n",
                            node(a, b, c),
                            0.01 * a,
                            0.01 * b,
                            0.002 * (c - 1));
        if (a == 0) text += fmt::format("SPC1,1,123,{}\n", node(a, b, c));
      }
    }
  }
  for (int k = 0; k < 10; ++k) {
    const int a = 2 * k;
    text += fmt::format(
        "CHEXA,{},1,{},{},{},{},{},{}\n,{},{},{},{},{},{},{},{}\n"
        ",{},{},{},{},{},{}\n",
        k + 1,
        node(a, 0, 0),
        node(a + 2, 0, 0),
        node(a + 2, 2, 0),
        node(a, 2, 0),
        node(a, 0, 2),
        node(a + 2, 0, 2),
        node(a + 2, 2, 2),
        node(a, 2, 2),
        node(a + 1, 0, 0),
        node(a + 2, 1, 0),
        node(a + 1, 2, 0),
        node(a, 1, 0),
        node(a, 0, 1),
        node(a + 2, 0, 1),
        node(a + 2, 2, 1),
        node(a, 2, 1),
        node(a + 1, 0, 2),
        node(a + 2, 1, 2),
        node(a + 1, 2, 2),
        node(a, 1, 2));
  }
  return text + "PSOLID,1,1\nMAT1,1,2.1+11,,.3,7850.\nENDDATA\n";
}

class SolidTruth : public ::testing::Test {
 protected:
  VirtualBundleSpec spec() {
    folder_.write("bars.bdf", bar_deck());
    folder_.write("bricks.bdf", brick_deck());
    VirtualBundleSpec spec;
    spec.structure = (folder_.path() / "bars.bdf").string();
    spec.truth = (folder_.path() / "bricks.bdf").string();
    spec.band_hz = {{20.0, 400.0}};
    spec.points = 4;
    return spec;
  }
  TemporaryFolder folder_;
};

TEST_F(SolidTruth, IsMeasuredWhereTheModelHasGrids) {
  const VirtualSetup setup = set_up(spec());
  ASSERT_FALSE(setup.runs.empty());
  for (const VirtualRun& run : setup.runs) {
    EXPECT_TRUE(setup.model.model.has_grid(run.hammer.node));
    EXPECT_TRUE(setup.model.fine.has_grid(run.hammer.node));
  }
  EXPECT_EQ(setup.model.fine.solids.size(), 10U);
  EXPECT_EQ(setup.model.model.bars.size(), 10U);
}

// f1 = 3.5160 / (2 pi L^2) sqrt(E I / (rho A)) of a clamped beam. The width
// cannot give where the face is held, and gives beyond: the bricks are stiffer
// than the beam, and softer than one whose width gives nowhere, with
// E / (1 - nu^2).
TEST_F(SolidTruth, BendsAsItsBeamDoes) {
  const VirtualSetup setup = set_up(spec());
  const VirtualStructure structure =
      build_virtual_structure(setup.model, {}, 1.0, setup.component);
  const ReducedTruth truth =
      reduce_truth(structure, {}, {{11, 3, 1}}, 400.0, {});
  const double beam = 3.5160 / (2.0 * M_PI * 0.2 * 0.2) *
                      std::sqrt(2.1e11 * 1.0667e-10 / (7850.0 * 8e-5));
  ASSERT_GT(truth.frequency_hz.size(), 0);
  EXPECT_GT(truth.frequency_hz(0), beam);
  EXPECT_LT(truth.frequency_hz(0), beam / std::sqrt(1.0 - 0.3 * 0.3));
}

TEST_F(SolidTruth, MustHaveTheModelsGrids) {
  const VirtualBundleSpec good = spec();
  std::string moved = brick_deck();
  const std::string tip = "GRID,11,,0.2,0,0\n";
  ASSERT_NE(moved.find(tip), std::string::npos);
  moved.replace(moved.find(tip), tip.size(), "GRID,11,,0.2,0,0.001\n");
  folder_.write("bricks.bdf", moved);
  try {
    static_cast<void>(set_up(good));
    FAIL() << "a truth whose grid 11 is elsewhere was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("grid 11"), std::string::npos);
  }
}

TEST_F(SolidTruth, IsForDecks) {
  VirtualBundleSpec named = spec();
  named.structure = "frame";
  EXPECT_THROW(static_cast<void>(set_up(named)), InputError);
}

}  // namespace
}  // namespace tapfit::updating
