#include "updating/measurement/test_model.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/files/uff58.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sstream>

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

}  // namespace
}  // namespace tapfit::updating
