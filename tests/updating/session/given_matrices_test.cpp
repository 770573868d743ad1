// A model that comes as matrices, from recording to effect.
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/matrix_text.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/session/session.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>

namespace tapfit::updating {
namespace {

using nlohmann::json;

// K.mtx, M.mtx and dofs.csv of what a deck leaves free.
void write_matrices(const structure::Deck& deck,
                    const tapfit::testing::TemporaryFolder& folder) {
  const structure::System system = structure::assemble(deck);
  const std::vector<int> free = system.free_dofs();
  std::string table = "node,component,x,y,z\n";
  for (const int dof : free) {
    const structure::Grid& grid = deck.grids[static_cast<std::size_t>(dof / 6)];
    table += fmt::format("{},{},{},{},{}\n",
                         grid.id,
                         dof % 6 + 1,
                         grid.position.x(),
                         grid.position.y(),
                         grid.position.z());
  }
  folder.write("test/K.mtx",
               structure::matrix_market(
                   Eigen::MatrixXd(structure::extract(system.K, free))));
  folder.write("test/M.mtx",
               structure::matrix_market(
                   Eigen::MatrixXd(structure::extract(system.M, free))));
  folder.write("test/dofs.csv", table);
}

class GivenMatricesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    VirtualBundleSpec spec;
    spec.structure = "portal";
    spec.seed = 411;
    spec.points = 8;
    spec.hits = 3;
    spec.modulus_percent = 4.0;
    spec.effects = {parse_virtual_effect("added-mass@50=0.3")};
    make_virtual_bundle(spec, folder_.path() / "test");
    std::ifstream truth(folder_.path() / "test" / "truth.json");
    hidden_ = json::parse(truth).at("effects").at(0);
    std::ifstream in(folder_.path() / "test" / "test.json");
    test_ = json::parse(in);
    test_["model"] = {
        {"stiffness", "K.mtx"}, {"mass", "M.mtx"}, {"dofs", "dofs.csv"}};
    test_["uncertain"] = {
        {{"material", 1}, {"property", "E"}, {"sd_percent", 5.0}}};
    deck_ = structure::read_deck(folder_.path() / "test" / "model.bdf");
    write_matrices(deck_, folder_);
    folder_.write("test/test.json", test_.dump());
  }

  tapfit::testing::TemporaryFolder folder_;
  structure::Deck deck_;
  json test_;
  json hidden_;
};

TEST_F(GivenMatricesTest, AreComparedAndToldWhatIsMissing) {
  Session session(folder_.path() / "test");
  const Comparison before = session.base_comparison();
  const structure::Eigenmodes modes = structure::modes_of(deck_, 12);
  for (const ModePair& pair : before.pairs) {
    const Eigen::VectorXd& f = modes.frequency_hz;
    // Rounding of the matrices' text and the base's own 1e-6.
    EXPECT_LT((f.array() - pair.model_hz).abs().minCoeff(),
              2e-6 * pair.model_hz);
  }
  const Diagnosis diagnosis = session.diagnosis();
  EXPECT_EQ(diagnosis.verdict, "added-mass");
  ASSERT_FALSE(diagnosis.ladder.empty());
  session.add(parse_effect(
      fmt::format("added-mass@{}", hidden_.at("node").get<int>())));
  EXPECT_LT(session.comparison().error, 0.1 * before.error);
  const std::vector<Estimate> found = session.model_parameters();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "E:1");
  // What the mesh of bars lacks is some hundredths of a percent.
  EXPECT_NEAR(found[0].value, 1.04, 0.005);
  const double truth = hidden_.at("mass_kg");
  EXPECT_NEAR(found[1].value, truth, 0.05 * truth);
}

TEST_F(GivenMatricesTest, KnowNoOtherProperty) {
  test_["uncertain"][0]["property"] = "nu";
  folder_.write("test/test.json", test_.dump());
  Session session(folder_.path() / "test");
  EXPECT_THROW(static_cast<void>(session.comparison()), InputError);
}

}  // namespace
}  // namespace tapfit::updating
