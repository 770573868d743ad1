#include "updating/studies/sensitivity.hpp"

#include "updating/properties/uncertain_parts.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/studies/property_study.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

// The truss whole: 21 degrees of freedom, d K / d f of its first uncertain rod.
class SensitivityTest : public ::testing::Test {
 protected:
  SensitivityTest() {
    const structure::System system = structure::assemble(study_.deck());
    const std::vector<int> free = system.free_dofs();
    K_ = structure::extract(system.K, free);
    M_ = structure::extract(system.M, free);
    const std::vector<UncertainPart> parts =
        uncertain_parts(study_.deck(), {study_.bundle().uncertain[0]});
    dK_ = MatrixXd(structure::extract(parts.at(0).K, free));
  }

  [[nodiscard]] MatrixXcd receptance(complex<double> s, double factor) const {
    const MatrixXcd Z =
        (K_ + (factor - 1.0) * dK_).cast<complex<double>>() + s * s * M_;
    return Z.inverse();
  }

  PropertyStudy study_{TAPFIT_SOURCE_DIR "/recordings/paper-truss",
                       {{4, 2, 1}, {10, 2, 1}},
                       3000.0};
  MatrixXd K_;
  MatrixXd M_;
  MatrixXd dK_;
};

TEST_F(SensitivityTest, FactorsAChangeIntoAsManyColumnsAsItHasRanks) {
  const LowRankChange change = factor_change(dK_.cast<complex<double>>());
  EXPECT_EQ(change.U.cols(), 1);  // a rod is stiff along one direction
  const MatrixXcd product = change.U * change.V.transpose();
  EXPECT_LT((product - dK_).norm(), 1e-14 * dK_.norm());
  const MatrixXcd nothing = MatrixXcd::Zero(5, 5);
  EXPECT_EQ(factor_change(nothing).U.cols(), 0);
}

TEST_F(SensitivityTest, ChangedReceptanceIsThatOfTheChangedModel) {
  for (const double factor : {1.1, 2.0, 0.3}) {
    const MatrixXcd dZ = (factor - 1.0) * dK_.cast<complex<double>>();
    for (const double f : {20.0, 180.0, 390.0}) {
      const complex<double> s(0.0, 2.0 * M_PI * f);
      const auto changed =
          changed_receptance(receptance(s, 1.0), factor_change(dZ));
      ASSERT_TRUE(changed.has_value());
      const MatrixXcd solved = receptance(s, factor);
      // Two inversions of matrices of condition 1e3.
      EXPECT_LT((*changed - solved).norm(), 1e-10 * solved.norm());
    }
  }
}

TEST_F(SensitivityTest, SaysWhenTheChangedStructureIsSingular) {
  // Without its first rod the truss is a mechanism.
  const MatrixXcd dZ = -dK_.cast<complex<double>>();
  const MatrixXcd H = K_.inverse().cast<complex<double>>();
  EXPECT_FALSE(changed_receptance(H, factor_change(dZ)).has_value());
}

TEST_F(SensitivityTest, TendsToTheAnalyticOneInProportion) {
  const complex<double> s(0.0, 2.0 * M_PI * 100.0);
  const MatrixXcd H = receptance(s, 1.0);
  const MatrixXcd exact = analytic_sensitivity(H, dK_.cast<complex<double>>());
  double last = 0.0;
  for (const double dP : {1e-1, 1e-2, 1e-3}) {
    const auto S = finite_sensitivity(
        H, factor_change(dP * dK_.cast<complex<double>>()), dP);
    ASSERT_TRUE(S.has_value());
    const double error = sensitivity_error(exact.reshaped(), S->reshaped());
    // S = exact / (1 + dP h), h the rod's stiffness times its flexibility.
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 10.0, 1.0);
    }
    last = error;
  }
}

// In the base's modes H is phi diag(1 / (s^2 + omega^2)) phi'.
TEST_F(SensitivityTest, ReducedBaseGivesTheSame) {
  const VectorXcd s = lines_at(VectorXd::LinSpaced(9, 20.0, 420.0));
  const FrfModel model = study_.model_at(study_.nominal());
  const ModelState state = study_.state(model, study_.nominal());
  const ModelResponse response = model.respond(state, s, true);
  const BaseModes modes = model.base_modes(state);
  const auto& powers = model.base().part_power;
  const auto first = std::ranges::find(powers, std::vector<int>{1, 0, 0, 0, 0});
  ASSERT_NE(first, powers.end());
  const MatrixXcd dK =
      model.base()
          .K_part[static_cast<std::size_t>(first - powers.begin())]
          .cast<complex<double>>();
  const LowRankChange change = factor_change(1e-6 * dK);
  const Eigen::RowVectorXd v = model.row(10, 2);
  for (Index l = 0; l < s.size(); ++l) {
    const VectorXcd g =
        (modes.omega.cwiseAbs2().cast<complex<double>>().array() + s(l) * s(l))
            .inverse();
    const MatrixXcd H = modes.phi * g.asDiagonal() * modes.phi.transpose();
    const MatrixXcd analytic = s(l) * s(l) * analytic_sensitivity(H, dK);
    const complex<double> fitted = response.dH[0](l, 1);
    // The same formula in two orders: rounding.
    EXPECT_LT(std::abs((v * analytic * v.transpose()).value() - fitted),
              1e-10 * std::abs(fitted));
    const auto finite = finite_sensitivity(H, change, 1e-6);
    ASSERT_TRUE(finite.has_value());
    // A perturbation of 1e-6 times a flexibility of some 10 near a resonance.
    EXPECT_LT(
        std::abs(s(l) * s(l) * (v * *finite * v.transpose()).value() - fitted),
        1e-4 * std::abs(fitted));
  }
}

TEST(SensitivityErrorTest, IsTheMeanOfRelativeDeviations) {
  VectorXcd exact(3);
  exact << 2.0, complex<double>(0.0, -4.0), 0.0;
  VectorXcd other(3);
  other << 2.2, complex<double>(0.0, -4.0), 5.0;
  // (0.1 + 0) / 2; where the exact one is zero nothing can be said.
  EXPECT_NEAR(sensitivity_error(exact, other), 0.05, 1e-15);
}

}  // namespace
}  // namespace tapfit::updating
