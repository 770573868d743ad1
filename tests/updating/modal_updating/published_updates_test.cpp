// Structures that others built, measured and updated, from their matrices and
// modes alone. Both were published with an open MATLAB package for structural
// model updating: Y. Wang and others, Georgia Institute of Technology.
#include "tests/updating/support/mat_file.hpp"
#include "tests/updating/support/matrix_text.hpp"
#include "updating/modal_updating/modal_updater.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::MatFile;
using structure::through_matrix_market;

constexpr double kNone = std::numeric_limits<double>::infinity();

std::filesystem::path made_by_others(const std::string& name) {
  return TAPFIT_SOURCE_DIR "/../shared/data/" + name;
}

// 946 degrees of freedom; frame, truss, eleven pieces of the concrete deck and
// two support springs at either end, each a matrix of its own.
ScaledModel bridge_model(const MatFile& file) {
  std::vector<std::string> names{"Frame", "Truss"};
  for (int i = 1; i <= 11; ++i) names.push_back(fmt::format("Conc{}", i));
  for (const char* spring : {"y1", "z1", "y2", "z2"}) names.push_back(spring);
  ScaledModel model;
  for (const std::string& name : names) {
    model.parts.push_back(
        {name, through_matrix_market(name, file.at("K_" + name))});
  }
  model.K0 = model.parts.front().K;
  for (std::size_t j = 1; j < names.size(); ++j) model.K0 += model.parts[j].K;
  model.M0 = through_matrix_market("mass", file.at("M0"));
  return model;
}

// Means over 7 to 16 identifications, with the standard deviation of the mean.
MeasuredModes bridge_modes(const MatFile& model, const MatFile& modes) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  MeasuredModes measured;
  const VectorXd omega = modes.at("lambdaExp").reshaped().cwiseSqrt();
  const VectorXd of_lambda =
      modes.at("std_lambdaExp")
          .reshaped()
          .cwiseQuotient(VectorXd(modes.at("numTest").reshaped()).cwiseSqrt());
  measured.frequency_hz = omega / kTwoPi;
  measured.frequency_sd = of_lambda.cwiseQuotient(2.0 * kTwoPi * omega);
  for (const double dof : model.at("measDOFs").reshaped()) {
    measured.dofs.push_back(static_cast<int>(dof) - 1);
  }
  measured.shape = modes.at("psiExp_m");
  measured.shape_sd =
      modes.at("std_psiExp").cwiseQuotient(modes.at("numVldCH").cwiseSqrt());
  // The point that a shape was divided by seems to have no scatter: what it has
  // is in the others.
  for (auto sd : measured.shape_sd.colwise()) {
    const double typical =
        std::sqrt(sd.squaredNorm() / static_cast<double>(sd.size() - 1));
    sd = (sd.array() > 0.0).select(sd, typical).eval();
  }
  return measured;
}

// As the authors set them: steel by 10 %, concrete -20 to 40 %, springs from
// (nearly) none to eleven times.
Prior bridge_bounds() {
  Prior prior{VectorXd::Zero(17),
              VectorXd::Constant(17, kNone),
              VectorXd::Constant(17, -0.2),
              VectorXd::Constant(17, 0.4)};
  prior.lower.head(2).setConstant(-0.1);
  prior.upper.head(2).setConstant(0.1);
  prior.lower.tail(4).setConstant(-0.999);
  prior.upper.tail(4).setConstant(10.0);
  return prior;
}

class BridgeUpdate : public testing::Test {
 protected:
  void SetUp() override {
    const auto model =
        made_by_others("pedestrian-bridge/SteelPedestrianBridgeExp.mat");
    const auto modes = made_by_others("pedestrian-bridge/ExpModeInfo_FEM.mat");
    for (const auto& path : {model, modes}) {
      if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << path << " is not here";
      }
    }
    const MatFile matrices(model);
    model_ = bridge_model(matrices);
    measured_ = bridge_modes(matrices, MatFile(modes));
  }

  [[nodiscard]] VectorXd off(const VectorXd& frequency_hz) const {
    return (frequency_hz - measured_.frequency_hz).cwiseAbs();
  }

  ScaledModel model_;
  MeasuredModes measured_;
};

TEST_F(BridgeUpdate, ReachesItsAuthorsFrequencies) {
  // Each shape one datum, as the authors weigh them.
  ModalUpdateOptions options;
  options.independent = 1.0;
  const ModalUpdate found = modal_update(
      model_, measured_, bridge_bounds(), VectorXd::Zero(17), options);
  EXPECT_TRUE(found.converged) << found.message;
  // The model has the first two modes the other way round.
  ASSERT_EQ(found.before.pairs.size(), 5U);
  EXPECT_EQ(found.before.pairs[0].model, 1);
  EXPECT_EQ(found.before.pairs[1].model, 0);
  EXPECT_EQ(found.after.pairs[0].model, 0);
  EXPECT_EQ(found.after.pairs[1].model, 1);
  VectorXd published(5);
  published << 4.063, 4.557, 6.819, 8.652, 11.43;
  VectorXd printed(5);  // half the last digit
  printed << 5e-4, 5e-4, 5e-4, 5e-4, 5e-3;
  const VectorXd theirs = off(published);
  const VectorXd ours = off(found.after.frequency_hz);
  for (Index i = 0; i < 5; ++i) {
    EXPECT_LE(ours(i), theirs(i) + printed(i)) << i;
  }
  EXPECT_LE(ours.cwiseQuotient(measured_.frequency_sd).norm(),
            theirs.cwiseQuotient(measured_.frequency_sd).norm());
  EXPECT_GT(found.after.mac.minCoeff(), 0.88) << found.after.mac.transpose();
}

TEST_F(BridgeUpdate, FindsTheSoftSupport) {
  const ModalUpdate found =
      modal_update(model_, measured_, bridge_bounds(), VectorXd::Zero(17));
  EXPECT_TRUE(found.converged) << found.message;
  // Five frequencies and five shapes at 58 points, each in its own measure.
  EXPECT_LT(off(found.after.frequency_hz)
                .cwiseQuotient(measured_.frequency_sd)
                .maxCoeff(),
            2.0);
  // The spring along y at one end has lost more than half of its stiffness,
  // and of the four it is the one that the data determine best.
  const Index y1 = 13;
  const double sd = found.standard_error(y1);
  EXPECT_LT(found.theta(y1) + 4.0 * sd, -0.5);
  EXPECT_EQ(found.standard_error.tail(4).minCoeff(), sd);
  // No piece of the deck can be told from the others: hence the bounds.
  EXPECT_GT(found.standard_error.segment(2, 11).minCoeff(), 1.0);
}

// 12.060 lb a floor, 10 lbf/in a storey, from the ground up.
ScaledModel frame_model() {
  ScaledModel model;
  MatrixXd K = MatrixXd::Zero(4, 4);
  for (Index j = 0; j < 4; ++j) {
    MatrixXd storey = MatrixXd::Zero(4, 4);
    storey(j, j) = 10.0;
    if (j > 0) {
      storey(j - 1, j - 1) = 10.0;
      storey(j - 1, j) = storey(j, j - 1) = -10.0;
    }
    K += storey;
    const std::string name = fmt::format("storey {}", j + 1);
    model.parts.push_back({name, through_matrix_market(name, storey)});
  }
  constexpr double kGravity = 386.088;  // in/s^2
  model.K0 = through_matrix_market("stiffness", K);
  model.M0 = through_matrix_market(
      "mass", MatrixXd(12.060 / kGravity * MatrixXd::Identity(4, 4)));
  return model;
}

// The first modes at the lowest floors. Nothing is said of their scatter: 0.5 %
// of a frequency and 5 % of a shape's largest entry, 1, are assumed.
MeasuredModes frame_modes(const MatFile& file, Index modes, int floors) {
  MeasuredModes measured;
  measured.frequency_hz = file.at("test_frequency").reshaped().head(modes);
  measured.frequency_sd = 0.005 * measured.frequency_hz;
  for (int i = 0; i < floors; ++i) measured.dofs.push_back(i);
  measured.shape = file.at("test_mode").topLeftCorner(floors, modes);
  measured.shape_sd = MatrixXd::Constant(floors, modes, 0.05);
  return measured;
}

class FrameUpdate : public testing::Test {
 protected:
  void SetUp() override {
    const auto path =
        made_by_others("four-storey-frame/FourStoryStructure.mat");
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
    file_.emplace(path);
    model_ = frame_model();
    authors_ << -0.2477, -0.2689, -0.1188, 0.5775;
  }

  [[nodiscard]] ModalUpdate update(Index modes, int floors) const {
    const Prior prior{VectorXd::Zero(4),
                      VectorXd::Constant(4, kNone),
                      VectorXd::Constant(4, -0.95),
                      VectorXd::Constant(4, 5.0)};
    return modal_update(
        model_, frame_modes(*file_, modes, floors), prior, VectorXd::Zero(4));
  }

  // Relative, of all four frequencies.
  [[nodiscard]] VectorXd off(const VectorXd& theta) const {
    const VectorXd f =
        structure::eigenmodes(model_.stiffness(theta), model_.M0, 4)
            .frequency_hz;
    const VectorXd measured = file_->at("test_frequency").reshaped();
    return (f - measured).cwiseQuotient(measured).cwiseAbs();
  }

  std::optional<MatFile> file_;
  ScaledModel model_;
  VectorXd authors_ = VectorXd(4);
};

TEST_F(FrameUpdate, AgreesWithItsAuthorsOnTheirData) {
  // Two modes at three floors are what they used.
  const ModalUpdate found = update(2, 3);
  EXPECT_TRUE(found.converged) << found.message;
  for (Index j = 0; j < 4; ++j) {
    EXPECT_LT(std::abs(found.theta(j) - authors_(j)),
              2.0 * found.standard_error(j))
        << j;
  }
  // Also of the two modes that the fit has not seen.
  EXPECT_TRUE((off(found.theta).array() < off(authors_).array()).all())
      << off(found.theta).transpose() << "\n"
      << off(authors_).transpose();
}

TEST_F(FrameUpdate, MatchesAllFourModes) {
  const ModalUpdate found = update(4, 4);
  EXPECT_TRUE(found.converged) << found.message;
  EXPECT_LT(found.before.mac.minCoeff(), 0.75);
  EXPECT_GT(found.after.mac.minCoeff(), 0.99);
  const VectorXd ours = off(found.theta);
  EXPECT_TRUE((ours.array() < off(authors_).array()).all()) << ours.transpose();
  EXPECT_LT(ours.maxCoeff(), 0.001);
  EXPECT_LT(found.standard_error.maxCoeff(), 0.05);
}

}  // namespace
}  // namespace tapfit::updating
