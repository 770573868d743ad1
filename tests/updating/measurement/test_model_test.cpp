#include "updating/measurement/test_model.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/files/uff58.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// A bar of two grids, clamped at grid 1.
constexpr const char* bar =
    "MAT1,1,7.0+10,,0.3,2700.\n"
    "PBAR,1,1,1.-4,1.-8,1.-8,1.-8\n"
    "GRID,1,,0.,0.,0.,,123456\n"
    "GRID,2,,1.,0.,0.\n"
    "CBAR,1,1,1,2,0.,0.,1.\n";

class TestModel : public ::testing::Test {
 protected:
  structure::Deck read(const Dof& hammer,
                       const Dof& sensor,
                       const std::string& more = {}) {
    folder_.write("model.bdf", bar + more);
    acquisition::TestBundle bundle;
    bundle.folder = folder_.path();
    bundle.deck = folder_.path() / "model.bdf";
    acquisition::Run run;
    run.hammer = {0, hammer};
    run.sensors = {{1, sensor}};
    bundle.runs = {run};
    return read_test_model(bundle);
  }
  tapfit::testing::TemporaryFolder folder_;
};

TEST_F(TestModel, WarnsOfAPointThatTheModelHolds) {
  EXPECT_TRUE(read({2, 3, 1}, {2, 2, 1}).warnings.empty());
  const structure::Deck deck = read({2, 3, 1}, {1, 3, -1});
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_NE(deck.warnings[0].find("runs[0].sensors[0]"), std::string::npos);
  EXPECT_NE(deck.warnings[0].find("1Z-"), std::string::npos);
}

// The same sensor in two runs.
TEST_F(TestModel, NamesAHeldPointOnce) {
  folder_.write("model.bdf", bar);
  acquisition::TestBundle bundle;
  bundle.deck = folder_.path() / "model.bdf";
  acquisition::Run run;
  run.hammer = {0, {2, 3, 1}};
  run.sensors = {{1, {1, 3, 1}}};
  bundle.runs = {run, run};
  EXPECT_EQ(read_test_model(bundle).warnings.size(), 1U);
}

class ReadyFrfs : public TestModel {
 protected:
  structure::Deck read(const Dof& response) {
    signal::Frf frf;
    frf.response = response;
    frf.reference = {2, 3, 1};
    signal::FrfSet set;
    set.s.resize(3);
    frf.H.resize(3);
    for (Eigen::Index k = 0; k < 3; ++k) {
      set.s(k) = {0.0, 10.0 * static_cast<double>(k + 1)};
      frf.H(k) = {1.0, 0.1};
    }
    set.frfs = {frf};
    std::ostringstream text;
    signal::write_frfs_uff(set, "bar", text);
    folder_.write("model.bdf", bar);
    acquisition::TestBundle bundle;
    bundle.deck = folder_.path() / "model.bdf";
    bundle.frfs = folder_.write("measured.uff", text.str());
    return read_test_model(bundle);
  }
};

TEST_F(ReadyFrfs, AreWarnedOfWhereTheModelHoldsThem) {
  EXPECT_TRUE(read({2, 2, 1}).warnings.empty());
  const structure::Deck deck = read({1, 3, -1});
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_NE(deck.warnings[0].find("measured.uff"), std::string::npos);
  EXPECT_NE(deck.warnings[0].find("1Z-"), std::string::npos);
}

TEST_F(ReadyFrfs, AreRefusedAtAGridThatTheModelLacks) {
  try {
    static_cast<void>(read({9, 3, 1}));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "measured.uff");
  }
}

TEST_F(TestModel, TakesDampersWithoutAWarning) {
  const structure::Deck deck = read({2, 3, 1}, {2, 2, 1}, "CDAMP2,7,3.5,2,3\n");
  EXPECT_TRUE(deck.warnings.empty());
}

TEST_F(TestModel, KnowsWhatARigidElementHolds) {
  // Grid 3 follows the clamped one, grid 4 the tip in x and y alone.
  const std::string rigid =
      "GRID,3,,0.,.1,0.\nRBE2,5,1,123456,3\n"
      "GRID,4,,1.,.1,0.,,3\nRBE2,6,2,12,4\n";
  EXPECT_TRUE(read({2, 3, 1}, {4, 1, 1}, rigid).warnings.empty());
  EXPECT_EQ(read({2, 3, 1}, {3, 1, 1}, rigid).warnings.size(), 1U);
  EXPECT_EQ(read({2, 3, 1}, {4, 3, 1}, rigid).warnings.size(), 1U);
}

// A spring that moves along z alone.
TEST_F(TestModel, WarnsOfAPointWithoutARowInGivenMatrices) {
  const std::string one = "%%MatrixMarket matrix array real general\n1 1\n2.\n";
  acquisition::TestBundle bundle;
  bundle.matrices = {folder_.write("K.mtx", one),
                     folder_.write("M.mtx", one),
                     folder_.write("dofs.csv", "7,Z\n")};
  acquisition::Run run;
  run.hammer = {0, {7, 3, 1}};
  run.sensors = {{1, {7, 3, 1}}};
  bundle.runs = {run};
  EXPECT_TRUE(read_test_model(bundle).warnings.empty());
  bundle.runs[0].sensors[0] = {1, {7, 1, 1}};
  const structure::Deck deck = read_test_model(bundle);
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_NE(deck.warnings[0].find("7X+"), std::string::npos);
}

TEST_F(TestModel, BlamesTheTableForANodeThatItLacks) {
  const std::string one = "%%MatrixMarket matrix array real general\n1 1\n2.\n";
  acquisition::TestBundle bundle;
  bundle.matrices = {folder_.write("K.mtx", one),
                     folder_.write("M.mtx", one),
                     folder_.write("dofs.csv", "7,Z\n")};
  acquisition::Run run;
  run.hammer = {0, {8, 3, 1}};
  bundle.runs = {run};
  try {
    static_cast<void>(read_test_model(bundle));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("dofs.csv"), std::string::npos)
        << error.what();
  }
}

TEST_F(TestModel, WarnsOfSupportsAlongTurnedAxes) {
  const std::string system = "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,.6,.8,0.\n";
  const structure::Deck slope = read(
      {2, 3, 1}, {2, 2, 1}, system + "GRID,3,,1.,1.,0.,1,2\nRBE2,6,2,456,3\n");
  ASSERT_EQ(slope.warnings.size(), 1U);
  EXPECT_NE(slope.warnings[0].find("GRID 3 (1 in all)"), std::string::npos);
  // A clamp is one along any axes.
  EXPECT_TRUE(read({2, 3, 1},
                   {2, 2, 1},
                   system + "GRID,3,,1.,1.,0.,1,123456\nPLOTEL,9,2,3\n")
                  .warnings.empty());
}

TEST_F(TestModel, RefusesAGridThatTheModelLacks) {
  try {
    static_cast<void>(read({7, 3, 1}, {2, 3, 1}));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "test.json: runs[0].hammer");
  }
}

// A bar of five grids and a file of modes that has them where they are, in mm
// and beside the model, or under other numbers.
class NamedGrids : public ::testing::Test {
 protected:
  std::vector<std::string> warnings(
      const std::vector<std::array<double, 2>>& at, bool turned = false) const {
    std::string deck =
        "MAT1,1,7.0+10,,0.3,2700.\nPBAR,1,1,1.-4,1.-8,1.-8,1.-8\n";
    for (int k = 0; k < 5; ++k) {
      deck += fmt::format("GRID,{},,{},{},0.\n", k + 1, 0.1 * k, 0.02 * k * k);
    }
    for (int k = 1; k < 5; ++k) {
      deck += fmt::format("CBAR,{0},1,{0},{1},0.,0.,1.\n", k, k + 1);
    }
    std::string uff;
    if (turned) {
      uff += "    -1\n  2420\n         1\nPart\n" +
             fmt::format("{:10}{:10}{:10}\nCS7\n", 7, 0, 8);
      const std::array<std::array<double, 3>, 4> rows{
          {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 0}}};
      for (const auto& row : rows) {
        uff += fmt::format(
            "{:25.16E}{:25.16E}{:25.16E}\n", row[0], row[1], row[2]);
      }
      uff += "    -1\n";
    }
    uff += "    -1\n  2411\n";
    for (std::size_t k = 0; k < at.size(); ++k) {
      uff += fmt::format("{:10}{:10}{:10}{:10}\n{:25.16E}{:25.16E}{:25.16E}\n",
                         k + 1,
                         0,
                         turned ? 7 : 0,
                         11,
                         at[k][0],
                         at[k][1],
                         0.0);
    }
    uff += "    -1\n    -1\n    55\nshape\nNONE\nNONE\nNONE\nNONE\n";
    uff += fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, 2, 2, 8, 2, 3);
    uff += fmt::format("{:10}{:10}{:10}{:10}\n", 2, 4, 0, 1);
    uff +=
        fmt::format("{:13.5E}{:13.5E}{:13.5E}{:13.5E}\n", 20.0, 1.0, 0.0, 0.0);
    for (std::size_t k = 0; k < at.size(); ++k) {
      uff += fmt::format(
          "{:10}\n{:13.5E}{:13.5E}{:13.5E}\n", k + 1, 0.0, 0.0, 1.0);
    }
    uff += "    -1\n";
    acquisition::TestBundle bundle;
    bundle.folder = folder_.path();
    bundle.deck = folder_.write("model.bdf", deck);
    bundle.modes = acquisition::ReadyModes{folder_.write("modes.uff", uff)};
    std::vector<std::string> found;
    for (const std::string& text : read_test_model(bundle).warnings) {
      if (text.find("coordinates") != std::string::npos) {
        found.push_back(text);
      }
    }
    return found;
  }
  tapfit::testing::TemporaryFolder folder_;
};

TEST_F(NamedGrids, AreWhereTheFileHasThem) {
  std::vector<std::array<double, 2>> same;
  std::vector<std::array<double, 2>> millimetres;
  std::vector<std::array<double, 2>> moved;
  for (int k = 0; k < 5; ++k) {
    const double x = 0.1 * k;
    const double y = 0.02 * k * k;
    same.push_back({x, y});
    millimetres.push_back({1000.0 * x, 1000.0 * y});
    moved.push_back({3.0 - y, 5.0 + x});  // and turned
  }
  EXPECT_TRUE(warnings(same).empty());
  const std::vector<std::string> scaled = warnings(millimetres);
  ASSERT_EQ(scaled.size(), 1U);
  EXPECT_NE(scaled[0].find("are 1000 times the model's"), std::string::npos)
      << scaled[0];
  EXPECT_TRUE(warnings(moved).empty());
  std::swap(same[1], same[4]);
  const std::vector<std::string> exchanged = warnings(same);
  ASSERT_EQ(exchanged.size(), 1U);
  EXPECT_NE(exchanged[0].find("2 of 5 points"), std::string::npos)
      << exchanged[0];
  EXPECT_NE(exchanged[0].find("\"geometry\": \"modes.uff\""),
            std::string::npos);
}

// Points with axes of their own lie by their coordinates, too.
TEST_F(NamedGrids, AreLookedForAtNodesWithAxesOfTheirOwn) {
  std::vector<std::array<double, 2>> at;
  for (int k = 0; k < 5; ++k) at.push_back({0.1 * k, 0.02 * k * k});
  EXPECT_TRUE(warnings(at, true).empty());
  std::swap(at[1], at[4]);
  const std::vector<std::string> exchanged = warnings(at, true);
  ASSERT_EQ(exchanged.size(), 1U);
  EXPECT_NE(exchanged[0].find("2 of 5 points"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::updating
