// Structures that others built, measured and updated, from their modes alone.
// Both were published with an open MATLAB package for structural model
// updating: Y. Wang and others, Georgia Institute of Technology.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/mat_file.hpp"
#include "tests/updating/support/matrix_text.hpp"
#include "updating/session/session.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using nlohmann::json;
using structure::MatFile;

std::filesystem::path made_by_others(const std::string& name) {
  return TAPFIT_SOURCE_DIR "/../shared/data/" + name;
}

/// @param shape, sd points x modes; sd of no size: not known
json modes_json(const VectorXd& hz,
                const VectorXd& hz_sd,
                const std::vector<std::string>& points,
                const MatrixXd& shape,
                const MatrixXd& sd) {
  json list = json::array();
  for (Index r = 0; r < hz.size(); ++r) {
    json mode = {{"frequency_hz", {{"value", hz(r)}, {"sd", hz_sd(r)}}}};
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto row = static_cast<Index>(k);
      mode["shape"][points[k]] = shape(row, r);
      if (sd.size() > 0) mode["shape_sd"][points[k]] = sd(row, r);
    }
    list.push_back(std::move(mode));
  }
  return {{"modes", std::move(list)}};
}

// 946 degrees of freedom, five modes at 58 points: means of 7 to 16
// identifications.
TEST(PublishedModes, TheFootbridgesFirstTwoArePairedTheOtherWayRound) {
  const auto model =
      made_by_others("pedestrian-bridge/SteelPedestrianBridgeExp.mat");
  const auto modes = made_by_others("pedestrian-bridge/ExpModeInfo_FEM.mat");
  for (const auto& path : {model, modes}) {
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  }
  const MatFile matrices(model);
  const MatFile measured(modes);
  std::string dofs;
  for (Index i = 0; i < matrices.at("K_whole").rows(); ++i) {
    dofs += fmt::format("{},Z\n", i + 1);
  }
  std::vector<std::string> points;
  for (const double dof : matrices.at("measDOFs").reshaped()) {
    points.push_back(fmt::format("{}Z+", static_cast<int>(dof)));
  }
  const VectorXd hz = measured.at("lambdaExp").reshaped().cwiseSqrt() /
                      (2.0 * std::numbers::pi);
  const tapfit::testing::TemporaryFolder folder;
  folder.write("K.mtx", structure::matrix_market(matrices.at("K_whole")));
  folder.write("M.mtx", structure::matrix_market(matrices.at("M0")));
  folder.write("dofs.csv", dofs);
  folder.write(
      "modes.json",
      modes_json(
          hz, VectorXd::Zero(hz.size()), points, measured.at("psiExp_m"), {})
          .dump());
  folder.write("test.json", R"({"tapfit": 1, "modes": "modes.json", "model":
    {"stiffness": "K.mtx", "mass": "M.mtx", "dofs": "dofs.csv"}})");
  Session session(folder.path());
  const Comparison& c = session.base_comparison();
  ASSERT_EQ(c.pairs.size(), 5U);
  EXPECT_EQ(c.pairs[0].model, 1);
  EXPECT_EQ(c.pairs[1].model, 0);
  const std::array<double, 5> published{4.875, 4.660, 6.654, 9.901, 11.381};
  for (std::size_t k = 0; k < published.size(); ++k) {
    // Printed to three decimals.
    EXPECT_NEAR(c.pairs[k].model_hz, published[k], 6e-4);
  }
}

// 12.060 lb a floor, 10 lbf/in a storey, from the ground up: rods along x, one
// modulus each, of k = E A / L.
constexpr double floor_kg = 12.060 * 0.45359237;
constexpr double storey_n_per_m = 10.0 * 4.4482216 / 0.0254;

std::string frame_text() {
  std::string text = "BEGIN BULK\n";
  for (int i = 0; i <= 4; ++i) {
    text += fmt::format("GRID,{},,{}.,0.,0.,,23456\n", i + 1, i);
  }
  for (int i = 1; i <= 4; ++i) {
    text += fmt::format("CROD,{0},{0},{0},{1}\nPROD,{0},{0},1.-4\n", i, i + 1);
    text += fmt::format("MAT1,{},{:.8e},,.3\n", i, storey_n_per_m / 1e-4);
    text += fmt::format("CONM2,{},{},,{:.8e}\n", 100 + i, i + 1, floor_kg);
  }
  return text + "SPC1,1,1,1\nENDDATA\n";
}

TEST(PublishedModes, TheFramesStoreysComeOutAsItsAuthorsHaveThem) {
  const auto path = made_by_others("four-storey-frame/FourStoryStructure.mat");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const MatFile file(path);
  const VectorXd hz = file.at("test_frequency").reshaped();
  const MatrixXd& shape = file.at("test_mode");
  const tapfit::testing::TemporaryFolder folder;
  folder.write("model.bdf", frame_text());
  // Nothing is said of their scatter: 0.5 % of a frequency and 5 % of a shape's
  // largest entry, 1, are assumed.
  folder.write("modes.json",
               modes_json(hz,
                          0.005 * hz,
                          {"2X+", "3X+", "4X+", "5X+"},
                          shape,
                          MatrixXd::Constant(4, 4, 0.05))
                   .dump());
  std::string uncertain;
  for (int i = 1; i <= 4; ++i) {
    uncertain += fmt::format(
        R"({}{{"material": {}, "property": "E", "sd_percent": 100}})",
        i == 1 ? "" : ", ",
        i);
  }
  folder.write("test.json",
               R"({"tapfit": 1, "modes": "modes.json", "model": "model.bdf",
                   "uncertain": [)" +
                   uncertain + "]}");
  Session session(folder.path());
  EXPECT_GT(session.base_comparison().error, 0.03);
  session.fit_uncertain();
  const Comparison& after = session.comparison();
  ASSERT_EQ(after.pairs.size(), 4U);
  for (const ModePair& pair : after.pairs) {
    EXPECT_GT(pair.mac, 0.99);
    EXPECT_LT(std::abs(pair.error_percent), 0.3);
  }
  // Theirs are from two modes at three floors: all four modes at all floors,
  // minimised apart from this program, end 0.03 to 0.11 away.
  const std::array<double, 4> authors{-0.2477, -0.2689, -0.1188, 0.5775};
  const std::vector<Estimate> found = session.model_parameters();
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const double theta = found[k].value / (storey_n_per_m / 1e-4) - 1.0;
    EXPECT_NEAR(theta, authors[k], 0.15) << k;
  }
}

}  // namespace
}  // namespace tapfit::updating
