#include "modal/mode_set/read_modes_uff.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/uff55.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

namespace tapfit::modal {
namespace {

namespace fs = std::filesystem;

const fs::path samples = TAPFIT_SOURCE_DIR "/../shared/data/uff-samples";

ModeSet two_modes(bool rotations, bool scaled) {
  ModeSet set;
  set.dofs = {{4, 3, 1}, {9, 1, 1}, {9, rotations ? 5 : 3, 1}};
  set.scaled = scaled;
  for (const double omega : {125.0, 300.0}) {
    Mode mode;
    mode.pole = {-0.01 * omega, omega};
    mode.frequency_hz = std::abs(mode.pole) / (2.0 * std::numbers::pi);
    mode.damping_ratio = -mode.pole.real() / std::abs(mode.pole);
    mode.shape.resize(3);
    mode.shape << std::complex<double>(0.5, 0.25), -1.5, 0.01 * omega;
    set.modes.push_back(mode);
  }
  return set;
}

TEST(ReadModesUff, GivesBackWhatWasWritten) {
  for (const ModeDataset as : {ModeDataset::Uff55, ModeDataset::Uff2414}) {
    for (const bool rotations : {false, true}) {
      for (const bool scaled : {false, true}) {
        const ModeSet written = two_modes(rotations, scaled);
        const ModeSet read =
            read_modes_uff_text(modes_as_uff(written, "A plate", as), "memory")
                .set;
        ASSERT_EQ(read.modes.size(), 2U);
        EXPECT_EQ(read.dofs, written.dofs);
        EXPECT_EQ(read.scaled, scaled);
        for (std::size_t k = 0; k < 2; ++k) {
          // The file holds six digits.
          EXPECT_NEAR(read.modes[k].frequency_hz,
                      written.modes[k].frequency_hz,
                      1e-5 * written.modes[k].frequency_hz);
          EXPECT_NEAR(read.modes[k].damping_ratio, 0.01, 1e-5);
          EXPECT_LT((read.modes[k].shape - written.modes[k].shape).norm(),
                    2e-5 * written.modes[k].shape.norm());
        }
      }
    }
  }
}

// What was shaped along a node's own axes is along global ones, or its own.
TEST(ReadModesUff, ShapesCountAlongTheNodesSystems) {
  const ModeSet written = two_modes(false, true);
  ASSERT_FALSE(written.dofs.empty());
  acquisition::UffGeometry geometry;
  for (const Dof& dof : written.dofs) {
    geometry.nodes[dof.node] = {0.1 * dof.node, 0.0, 0.0};
    geometry.node_systems[dof.node] = {0, 4, {}};
  }
  // x, y, z are Y, Z, X.
  geometry.systems[4].points << 0, 0, 1, 0, 1, 0, 0, 0, 0;
  std::ostringstream out;
  write_geometry(geometry, acquisition::UffNodes::D2411, out);
  const ModeSet read =
      read_modes_uff_text(modes_as_uff(written, "A plate") + out.str(),
                          "memory")
          .set;
  ASSERT_EQ(read.dofs.size(), written.dofs.size());
  for (std::size_t k = 0; k < written.dofs.size(); ++k) {
    Dof turned = written.dofs[k];
    turned.component = turned.component % 3 + 1;
    const auto at = std::ranges::find(read.dofs, turned);
    ASSERT_NE(at, read.dofs.end()) << name(turned);
    EXPECT_LT(std::abs(read.modes[0].shape(at - read.dofs.begin()) -
                       written.modes[0].shape(static_cast<Eigen::Index>(k))),
              2e-5 * written.modes[0].shape.norm());
  }
}

TEST(ReadModesUff, ReadsNormalModesAndScalesThemByTheirMass) {
  const std::string text =
      "    -1\n    55\nNONE\nNONE\nNONE\nNONE\nNONE\n"
      "         1         2         2         8         2         3\n"
      "         2         4         1         1\n"
      "  1.00000E+01  4.00000E+00  2.00000E-02  0.00000E+00\n"
      "         7\n  0.00000E+00  0.00000E+00  6.00000E+00\n    -1\n";
  const ModeSet set = read_modes_uff_text(text, "memory").set;
  ASSERT_EQ(set.modes.size(), 1U);
  EXPECT_NEAR(set.modes[0].frequency_hz, 10.0, 1e-12);
  EXPECT_NEAR(set.modes[0].damping_ratio, 0.02, 1e-12);
  ASSERT_EQ(set.dofs.size(), 1U);
  EXPECT_EQ(set.dofs[0], (Dof{7, 3, 1}));
  // 6 / sqrt(4 kg)
  EXPECT_NEAR(std::abs(set.modes[0].shape(0)), 3.0, 1e-9);
}

TEST(ReadModesUff, TakesHalfTheLossFactorWhereThatIsGiven) {
  const std::string text =
      "    -1\n    55\nNONE\nNONE\nNONE\nNONE\nNONE\n"
      "         1         2         2         8         2         3\n"
      "         2         4         1         1\n"
      "  1.00000E+01  1.00000E+00  0.00000E+00  3.00000E-02\n"
      "         7\n  0.00000E+00  0.00000E+00  1.00000E+00\n    -1\n";
  const ModeSet set = read_modes_uff_text(text, "memory").set;
  ASSERT_EQ(set.modes.size(), 1U);
  EXPECT_NEAR(set.modes[0].damping_ratio, 0.015, 1e-12);
}

// A node that one dataset lacks was not measured there: it does not stand
// still.
TEST(ReadModesUff, LeavesOutPointsThatAModeHasNoValueAt) {
  std::string text = modes_as_uff(two_modes(false, true), "A plate");
  // The second dataset's last node, with its line of values.
  const std::size_t node = text.rfind("         9\n");
  ASSERT_NE(node, std::string::npos);
  text.erase(node, text.find('\n', node + 11) + 1 - node);
  const UffModes read = read_modes_uff_text(text, "memory");
  ASSERT_EQ(read.set.modes.size(), 2U);
  EXPECT_EQ(read.set.dofs, (std::vector<Dof>{{4, 3, 1}}));
  ASSERT_EQ(read.skipped.size(), 1U);
  EXPECT_NE(read.skipped[0].find("9X+"), std::string::npos) << read.skipped[0];
}

TEST(ReadModesUff, NamesDataAtElements) {
  std::string text =
      modes_as_uff(two_modes(false, true), "A plate", ModeDataset::Uff2414);
  // The third line of the second dataset says where its data stand.
  std::size_t at = text.find("2414", text.find("2414") + 4);
  for (int line = 0; line < 3; ++line) at = text.find('\n', at) + 1;
  text.replace(text.find('1', at), 1, "2");
  const UffModes read = read_modes_uff_text(text, "memory");
  EXPECT_EQ(read.set.modes.size(), 1U);
  ASSERT_EQ(read.skipped.size(), 1U);
  EXPECT_NE(read.skipped[0].find("not at nodes"), std::string::npos);
}

TEST(ReadModesUff, SaysWhatIsNoModeAndWhatIsBroken) {
  EXPECT_THROW((void)read_modes_uff("/nonexistent.uff"), InputError);
  EXPECT_THROW((void)read_modes_uff_text("    -1\n   151\nx\n    -1\n", "m"),
               InputError);
  std::string text = modes_as_uff(two_modes(false, true), "A plate");
  const std::size_t cut = text.find("         9\n");
  EXPECT_THROW((void)read_modes_uff_text(text.substr(0, cut + 20), "m"),
               InputError);
  std::string nan = modes_as_uff(two_modes(false, true), "A plate");
  nan.replace(nan.find(" 5.00000E-01"), 12, "         nan");
  EXPECT_THROW((void)read_modes_uff_text(nan, "m"), InputError);
  const std::string strain =
      "    -1\n    55\nNONE\nNONE\nNONE\nNONE\nNONE\n"
      "         1         2         2         3         2         3\n"
      "         2         4         1         1\n"
      "  1.00000E+01  4.00000E+00  2.00000E-02  0.00000E+00\n"
      "         7\n  0.00000E+00  0.00000E+00  6.00000E+00\n    -1\n";
  try {
    (void)read_modes_uff_text(strain, "m");
    FAIL() << "a strain is no motion";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no motion"), std::string::npos);
  }
}

TEST(ReadModesUff, ReadsWhatOtherProgramsWrite) {
  if (!fs::exists(samples)) GTEST_SKIP() << samples << " is not there";
  const ModeSet translations =
      read_modes_uff(samples / "uff55_translation.uff").set;
  ASSERT_EQ(translations.modes.size(), 3U);
  EXPECT_NEAR(translations.modes[0].frequency_hz, 10.0, 1e-9);
  EXPECT_NEAR(translations.modes[1].frequency_hz, 12.0, 1e-9);
  EXPECT_EQ(translations.dofs.size(), 12U);
  EXPECT_FALSE(translations.scaled);
  const ModeSet rotations =
      read_modes_uff(samples / "uff55_translation_rotation.uff").set;
  ASSERT_EQ(rotations.modes.size(), 1U);
  EXPECT_NEAR(rotations.modes[0].frequency_hz, 97.013, 1e-9);
  const ModeSet testlab =
      read_modes_uff(samples / "uff55 sample_test record10.uff").set;
  ASSERT_EQ(testlab.modes.size(), 1U);
  // |-0.1111111 + 41.11111 j| / 2 pi
  EXPECT_NEAR(testlab.modes[0].frequency_hz, 6.5431, 1e-3);
  const ModeSet permas = read_modes_uff(samples / "2411 and 2414.uff").set;
  ASSERT_EQ(permas.modes.size(), 10U);
  EXPECT_NEAR(permas.modes[0].frequency_hz, 0.956363, 1e-9);
  EXPECT_NEAR(permas.modes[1].frequency_hz, 2.34163, 1e-9);
  Eigen::MatrixXcd shapes(permas.modes[0].shape.size(), 10);
  for (Eigen::Index k = 0; k < 10; ++k) {
    shapes.col(k) = permas.modes[static_cast<std::size_t>(k)].shape;
  }
  const Eigen::MatrixXd own = auto_mac(shapes);
  for (Eigen::Index k = 0; k < 10; ++k) EXPECT_NEAR(own(k, k), 1.0, 1e-12);
}

}  // namespace
}  // namespace tapfit::modal
