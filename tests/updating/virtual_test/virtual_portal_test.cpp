#include "updating/virtual_test/virtual_portal.hpp"

#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_points.hpp"
#include "updating/virtual_test/virtual_structure.hpp"
#include "updating/virtual_test/virtual_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace tapfit::updating {
namespace {

TEST(VirtualPortal, HasItsMass) {
  const structure::Deck deck = portal_deck();
  // Two legs of 1 m, an upper bar of 1 m, a tie of 0.7 m; 30 mm x 15 mm steel.
  const double length = 2 * 1.0 + 1.0 + 0.7;
  EXPECT_NEAR(structure::total_mass(deck, structure::assemble(deck)),
              length * 0.030 * 0.015 * 7850.0,
              1e-9);
  EXPECT_EQ(test_direction(deck), 2) << "across its plane";
}

TEST(VirtualPortal, CardsAreTheDeck) {
  const auto file =
      std::filesystem::path(::testing::TempDir()) / "tapfit-portal.bdf";
  std::ofstream out(file);
  for (const std::string& card : portal_cards()) out << card << '\n';
  out.close();
  const structure::Deck read = structure::read_deck(file);
  EXPECT_TRUE(read.warnings.empty());
  const Eigen::VectorXd hz = model_shapes(read, 2, 220.0).frequency_hz;
  const Eigen::VectorXd own =
      model_shapes(portal_deck(), 2, 220.0).frequency_hz;
  ASSERT_EQ(hz.size(), own.size());
  ASSERT_GE(hz.size(), 5) << "enough modes in its band";
  // Cards hold six digits.
  EXPECT_LT((hz - own).cwiseQuotient(own).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(VirtualPortal, FeetTurnEachByItself) {
  const SupportEdge edge = support_edge(portal_deck());
  EXPECT_EQ(edge.turns, (std::vector{4, 5, 6}));
  ASSERT_EQ(edge.length_of.size(), 2U);
  for (const auto& [foot, length] : edge.length_of) {
    EXPECT_EQ(length, 1.0) << foot;
  }
}

TEST(VirtualPortal, TruthIsTheSameStructureFinerMeshed) {
  const std::optional<StructurePreset> preset = preset_of("portal");
  ASSERT_TRUE(preset);
  EXPECT_EQ(preset->model.fine.bars.size(),
            4 * preset->model.model.bars.size());
  const Eigen::VectorXd coarse =
      model_shapes(preset->model.model, 2, 220.0).frequency_hz;
  const Eigen::VectorXd fine =
      model_shapes(preset->model.fine, 2, 220.0).frequency_hz;
  ASSERT_EQ(coarse.size(), fine.size());
  // A consistent beam element's error of omega falls with (h / wavelength)^4:
  // 50 mm elements on bending waves of half a metre or more.
  EXPECT_LT((coarse - fine).cwiseQuotient(fine).cwiseAbs().maxCoeff(), 2e-3);
}

}  // namespace
}  // namespace tapfit::updating
