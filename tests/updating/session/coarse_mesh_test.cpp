// From recordings to findings on meshes as coarse as engineers make them, of
// lumped mass: the truth is the same deck with every element split twice.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace tapfit::updating {
namespace {

/// A clamped plate of 3 mm aluminium, `nx` by `ny` shells.
std::string plate(double length, double width, int nx, int ny) {
  std::string deck =
      "MAT1,1,7.+10,,.33,2700.\nPSHELL,1,1,.003,1,,1\n"
      "SPC1,1,123456";
  for (int j = 0; j <= ny; ++j) deck += fmt::format(",{}", 1 + j);
  deck += "\n";
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      deck += fmt::format("GRID,{},,{:.6f},{:.6f},0.\n",
                          1 + i * (ny + 1) + j,
                          length * i / nx,
                          width * j / ny);
    }
  }
  int element = 0;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const int p = 1 + i * (ny + 1) + j;
      const int q = p + ny + 1;
      deck += fmt::format(
          "CQUAD4,{},1,{},{},{},{}\n", ++element, p, q, q + 1, p + 1);
    }
  }
  return deck + "ENDDATA\n";
}

class CoarseMesh : public ::testing::Test {
 protected:
  Session session(const std::string& deck,
                  const std::string& effect,
                  std::array<double, 2> band_hz) const {
    VirtualBundleSpec spec;
    spec.structure = folder_.write("truth.bdf", deck).string();
    if (!effect.empty()) spec.effects = {parse_virtual_effect(effect)};
    spec.seed = 1;
    spec.points = 8;
    spec.hits = 3;
    spec.band_hz = band_hz;
    make_virtual_bundle(spec, folder_.path() / "test");
    return Session(folder_.path() / "test");
  }

  tapfit::testing::TemporaryFolder folder_;
};

double error(Session& session) { return session.ladder().back().error; }

// What splitting changes is a tenth and more of the frequencies; half of that
// and the modulus's 3 % are found, and nothing is missing.
TEST_F(CoarseMesh, IsNoEffect) {
  Session test = session(plate(0.5, 0.3, 10, 6), "", {8.0, 200.0});
  const Diagnosis& diagnosis = test.diagnosis();
  EXPECT_EQ(diagnosis.verdict, "none");
  EXPECT_LT(diagnosis.error_fitted, 0.01);
}

// A tenth of the floor, which counts the whole difference of the meshes.
TEST_F(CoarseMesh, HidesNoMassBelowItsFloor) {
  Session test =
      session(plate(0.5, 0.3, 10, 6), "added-mass@60=0.01", {8.0, 200.0});
  const Diagnosis& diagnosis = test.diagnosis();
  EXPECT_EQ(diagnosis.verdict, "added-mass");
  ASSERT_FALSE(diagnosis.ladder.empty());
  EXPECT_EQ(diagnosis.ladder[0].where.node, 60);
  // A gramme of a hundred: 1 % of what it moves.
  EXPECT_NEAR(diagnosis.ladder[0].parameters[0].value, 0.01, 2e-4);
}

TEST_F(CoarseMesh, ALossThatIsNotThereChangesNothing) {
  Session test = session(plate(0.4, 0.3, 5, 4), "", {8.0, 200.0});
  test.fit_uncertain();
  const double before = error(test);
  test.add(parse_effect("stiffness-loss@9"));
  EXPECT_LE(error(test), 1.001 * before);
}

TEST_F(CoarseMesh, LetsAClampBeAsStiffAsItIs) {
  Session test =
      session(plate(0.5, 0.13, 6, 2), "soft-support=700", {5.0, 150.0});
  test.fit_uncertain();
  test.add(parse_effect("soft-support@rotation"));
  const auto& found = test.ladder().back().parameters;
  const auto per_m = std::ranges::find(
      found, "rotational_stiffness_nm_per_rad_per_m", &Estimate::name);
  ASSERT_NE(per_m, found.end());
  // By the shift of the clamped plate's modes 3.5 % are left, and the clamp is
  // 2 to 10 % too soft.
  EXPECT_LT(error(test), 0.01);
  EXPECT_NEAR(per_m->value, 700.0, 0.005 * 700.0);
}

// Four masses and no more: the vectors of a loss have none of their own.
TEST_F(CoarseMesh, OfFourBarsShowsWhichIsSofter) {
  Session test = session(
      "GRID,1,,0.,0.,0.\nGRID,2,,.2,0.,0.\nGRID,3,,.4,0.,0.\n"
      "GRID,4,,.6,0.,0.\nGRID,5,,.8,0.,0.\nPBARL,1,1,,BAR\n,.03,.008\n"
      "MAT1,1,2.1+11,,.3,7850.\nCBAR,1,1,1,2,0.,1.,0.\nCBAR,2,1,2,3,0.,1.,0.\n"
      "CBAR,3,1,3,4,0.,1.,0.\nCBAR,4,1,4,5,0.,1.,0.\nSPC1,1,123456,1\n",
      "stiffness-loss@2=0.6",
      {5.0, 300.0});
  test.fit_uncertain();
  const double before = error(test);
  test.add(parse_effect("stiffness-loss@2"));
  EXPECT_LT(error(test), 0.5 * before);
  EXPECT_NEAR(test.ladder().back().parameters[0].value, 0.6, 0.03);
}

// A rod is a place where stiffness may be lost, in the screening too.
TEST_F(CoarseMesh, WithARodIsDiagnosedAndTheRodCanLoseStiffness) {
  Session test = session(
      "GRID,1,,0.,0.,0.\nGRID,2,,.2,0.,0.\nGRID,3,,.4,0.,0.\n"
      "GRID,4,,.6,0.,0.\nGRID,5,,0.,0.,.3\nPBARL,1,1,,BAR\n,.03,.008\n"
      "PROD,2,1,2.-6\nMAT1,1,2.1+11,,.3,7850.\nCBAR,1,1,1,2,0.,1.,0.\n"
      "CBAR,2,1,2,3,0.,1.,0.\nCBAR,3,1,3,4,0.,1.,0.\nCROD,11,2,5,4\n"
      "SPC1,1,123456,1,5\n",
      "",
      {5.0, 300.0});
  EXPECT_EQ(test.diagnosis().verdict, "none");
  test.fit_uncertain();
  const double before = error(test);
  test.add(parse_effect("stiffness-loss@11"));
  EXPECT_LE(error(test), 1.001 * before);
}

}  // namespace
}  // namespace tapfit::updating
