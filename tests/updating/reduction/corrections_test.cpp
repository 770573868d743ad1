#include "updating/reduction/corrections.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double length = 0.4;
constexpr double E = 2.1e11;
constexpr double nu = 0.3;
constexpr double rho = 7850.0;
constexpr double width = 0.03;
constexpr double height = 0.02;

// A bar on two hinges, bending in one plane; K1 = K2 = 5/6 / share.
structure::Deck hinged_bar(double share) {
  constexpr int elements = 20;
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= elements; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.\n", i + 1, length * i / elements);
  }
  for (int i = 1; i <= elements; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", i, i, i + 1);
  }
  const double k = shear_coefficient(share);
  text += fmt::format("PBAR,1,1,{},{},{},1e-8\n,,,,,,,,,\n,{},{}\n",
                      width * height,
                      width * std::pow(height, 3) / 12.0,
                      height * std::pow(width, 3) / 12.0,
                      k,
                      k);
  text += fmt::format("MAT1,1,{},,{},{}\n", E, nu, rho);
  text += "SPC1,1,1246,1,THRU,21\nSPC1,1,3,1,21\nENDDATA\n";
  return structure::deck_of(text);
}

class SectionShear : public ::testing::Test {
 protected:
  static BaseBuilder builder(double share, bool split) {
    BaseOptions options;
    options.high_hz = 4000.0;
    options.split = split;
    options.points = {6 * 5 + 2, 6 * 9 + 2};
    return {hinged_bar(share), {}, options, Progress{}};
  }

  // Of the lowest modes, with the factors given.
  static VectorXd frequencies(const BaseBuilder& of,
                              const std::vector<double>& factor) {
    const ReducedBase base = of.build({}, {});
    Eigen::MatrixXd K = base.K;
    Eigen::MatrixXd M = Eigen::MatrixXd::Identity(base.size(), base.size());
    for (std::size_t k = 0; k < base.part_power.size(); ++k) {
      const double c = part_coefficient(base.part_power[k], factor);
      K += c * base.K_part[k];
      M += c * base.M_part[k];
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(K,
                                                                           M);
    return solver.eigenvalues().head(modes).cwiseSqrt() / two_pi;
  }

  static constexpr Index modes = 4;
};

// omega^2 of a hinged bar that shears, without rotary inertia:
// EI b^4 / (rho A (1 + EI b^2 / (k G A))), b = n pi / L (Timoshenko).
TEST_F(SectionShear, IsThatOfAHingedBar) {
  const BaseBuilder coarse = builder(0.0, false);
  BaseBuilder fine = builder(0.0, true);
  const std::vector<Correction> corrections = fine.hold_corrections(coarse);
  ASSERT_EQ(corrections.size(), 2U);
  EXPECT_EQ(corrections[1].name, section_shear);
  const VectorXd as_it_is = frequencies(fine, {1.0, 1.0});
  const VectorXd sheared = frequencies(fine, {1.0, 2.0});
  const VectorXd twice = frequencies(fine, {1.0, 3.0});
  const double radius = height * height / 12.0;  // I / A
  const double EI_GA = E / (5.0 / 6.0 * E / (2.0 * (1.0 + nu))) * radius;
  for (Index n = 0; n < modes; ++n) {
    const double b = static_cast<double>(n + 1) * std::numbers::pi / length;
    const double shear = EI_GA * b * b;
    const double bending = std::sqrt(E * radius / rho) * b * b / two_pi;
    const double lost = bending * (1.0 - 1.0 / std::sqrt(1.0 + shear));
    // The mesh is exact to 1e-4 there, and lost is 1 to 13 % of it.
    EXPECT_NEAR(as_it_is(n), bending, 2e-4 * bending) << n;
    EXPECT_NEAR(as_it_is(n) - sheared(n), lost, 0.02 * lost) << n;
    // Linear in the share: what is left is of the shear's own square.
    const double lost_twice =
        bending * (1.0 - 1.0 / std::sqrt(1.0 + 2.0 * shear));
    EXPECT_NEAR(
        as_it_is(n) - twice(n), lost_twice, (0.02 + 2.0 * shear) * lost_twice)
        << n;
  }
}

TEST_F(SectionShear, IsOnlyWhereBarsDoNotShear) {
  const BaseBuilder coarse = builder(1.0, false);
  BaseBuilder fine = builder(1.0, true);
  EXPECT_EQ(fine.hold_corrections(coarse).size(), 1U);
}

// The deck with its card mended has the frequencies that the factor gives.
TEST_F(SectionShear, IsThatOfTheMendedDeck) {
  const BaseBuilder coarse = builder(0.0, false);
  BaseBuilder fine = builder(0.0, true);
  static_cast<void>(fine.hold_corrections(coarse));
  const VectorXd by_factor = frequencies(fine, {1.0, 2.0});
  const VectorXd mended = frequencies(builder(1.0, true), {});
  EXPECT_LT((by_factor - mended).cwiseQuotient(mended).cwiseAbs().maxCoeff(),
            1e-3);
}

}  // namespace
}  // namespace tapfit::updating
