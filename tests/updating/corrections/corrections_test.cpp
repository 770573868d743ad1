#include "updating/corrections/corrections.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/based_frame.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/corrections/deck_forms.hpp"
#include "updating/effects/joint_cards.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/properties/line_mass.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <Eigen/Eigenvalues>
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

// The base's modes at these factors.
Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes_with(
    const ReducedBase& base, const std::vector<double>& factor) {
  Eigen::MatrixXd K = base.K;
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(base.size(), base.size());
  for (std::size_t k = 0; k < base.part_power.size(); ++k) {
    const double c = part_coefficient(base.part_power[k], factor);
    K += c * base.K_part[k];
    M += c * base.M_part[k];
  }
  return {K, M};
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
    return modes_with(base, factor).eigenvalues().head(modes).cwiseSqrt() /
           two_pi;
  }

  static constexpr Index modes = 4;
};

// omega^2 of a hinged bar that shears, without rotary inertia:
// EI b^4 / (rho A (1 + EI b^2 / (k G A))), b = n pi / L (Timoshenko).
TEST_F(SectionShear, IsThatOfAHingedBar) {
  const BaseBuilder coarse = builder(0.0, false);
  BaseBuilder fine = builder(0.0, true);
  const std::vector<Correction> corrections = fine.hold_corrections(coarse);
  ASSERT_EQ(corrections.size(), 3U);
  EXPECT_EQ(corrections[1].name, section_shear);
  const VectorXd as_it_is = frequencies(fine, {1.0, 1.0, 1.0});
  const VectorXd sheared = frequencies(fine, {1.0, 2.0, 1.0});
  const VectorXd twice = frequencies(fine, {1.0, 3.0, 1.0});
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
  const std::vector<Correction> corrections = fine.hold_corrections(coarse);
  ASSERT_EQ(corrections.size(), 2U);
  EXPECT_EQ(corrections[1].name, line_mass);
}

// The deck with its card mended has the frequencies that the factor gives.
TEST_F(SectionShear, IsThatOfTheMendedDeck) {
  const BaseBuilder coarse = builder(0.0, false);
  BaseBuilder fine = builder(0.0, true);
  static_cast<void>(fine.hold_corrections(coarse));
  const VectorXd by_factor = frequencies(fine, {1.0, 2.0, 1.0});
  const VectorXd mended = frequencies(builder(1.0, true), {});
  EXPECT_LT((by_factor - mended).cwiseQuotient(mended).cwiseAbs().maxCoeff(),
            1e-3);
}

// Of unit modal mass, at the points that are measured or hit: points x modes.
Eigen::MatrixXd shapes(const ReducedBase& base,
                       const std::vector<double>& factor,
                       const std::vector<int>& points) {
  Eigen::MatrixXd u = base.rows.all()(points, Eigen::all) *
                      modes_with(base, factor).eigenvectors().leftCols(4);
  for (auto mode : u.colwise()) mode *= mode(0) < 0.0 ? -1.0 : 1.0;
  return u;
}

// What a form changes of the shapes, too, not of the frequencies alone.
TEST(Corrections, ChangeShapesAsTheMendedDeckDoes) {
  const support::BasedFrame frame;
  const std::vector<int> points = measured_points(frame.deck, frame.bundle).all;
  const auto mended = deck_forms(structure::refine_mesh(frame.deck).deck);
  ASSERT_EQ(mended.size(), 3U);
  ASSERT_EQ(frame.corrections.size(), 4U);
  const std::vector<double> as_it_is(5, 1.0);  // E, the mesh, three forms
  for (std::size_t k = 0; k < mended.size(); ++k) {
    std::vector<double> factor = as_it_is;
    factor[2 + k] = 2.0;
    ASSERT_EQ(frame.corrections[1 + k].name, mended[k].correction.name);
    const ReducedBase other =
        support::frame_builder(mended[k].deck, frame.bundle, false)
            .build({}, {});
    const Eigen::MatrixXd truth = shapes(other, {1.0}, points);
    for (const BaseUse use : {BaseUse::Scan, BaseUse::Fit}) {
      const ReducedBase base = frame.builder.build({}, {}, use);
      const auto off = [&](const std::vector<double>& at) {
        return (shapes(base, at, points) - truth).norm() / truth.norm();
      };
      EXPECT_GT(off(as_it_is), 0.004);
      // Stiffness is held by the modes to four times the band alone: a sixth is
      // left of shear, a quarter of corners, which bend in one place.
      const double left = mended[k].of_mass ? 0.02 : 0.35;
      EXPECT_LT(off(factor), left * off(as_it_is)) << mended[k].correction.name;
    }
  }
}

// omega^2 of the lowest modes with the first of the changes at p. By
// M v = v K / omega^2: where grids turn without mass, the largest would drown
// them.
VectorXd lowest(const ReducedBase& base,
                const std::vector<double>& factor,
                double p) {
  Eigen::MatrixXd K = base.K + p * base.terms.at(0).S;
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(base.size(), base.size());
  for (std::size_t k = 0; k < base.part_power.size(); ++k) {
    const double c = part_coefficient(base.part_power[k], factor);
    K += c * base.K_part[k];
    M += c * base.M_part[k];
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      M, K, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().tail(4).reverse().cwiseInverse();
}

// Beyond a joint that gives, sections turn with their side of it.
TEST(Corrections, OfMassMoveWithAJointsSide) {
  const support::BasedFrame frame;
  Location corner;
  corner.nodes = {9};
  corner.elements = {9};
  const std::vector<StiffnessChange> joint = {
      {ChangeKind::Joint,
       {"joint", corner},
       effects::turned_across(corner, frame.context())}};
  const BaseBuilder mended = support::frame_builder(
      without_line_mass(structure::refine_mesh(frame.deck).deck),
      frame.bundle,
      false);
  const ReducedBase truth = mended.build({}, joint);
  const ReducedBase base = frame.builder.build({}, joint);
  ASSERT_EQ(frame.corrections.back().name, line_mass);
  for (const double stiffness : {1e3, 1e5}) {  // EI / L = 5e4 N m
    const VectorXd is = lowest(base, {1.0, 1.0, 1.0, 1.0, 2.0}, stiffness);
    const VectorXd was = lowest(base, {1.0, 1.0, 1.0, 1.0, 1.0}, stiffness);
    const VectorXd right = lowest(truth, {1.0}, stiffness);
    for (Index r = 0; r < is.size(); ++r) {
      // Left out on the side it would be 1e-2 at the softer joint.
      EXPECT_NEAR(is(r), right(r), 1e-5 * (was(r) - right(r))) << r;
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
