// What hanging free leaves of a spring to ground, against a rigid beam's closed
// forms: moved at x from its middle it has the mass m / (1 + 12 x^2 / L^2).
#include "updating/effects/suspension.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::effects {
namespace {

constexpr double hung_kg = 7850.0 * 0.02 * 0.006;
constexpr double hung_hz = 1.0;

// 1 m of 20 mm x 6 mm steel along x, free to bend in z.
std::string hung_text(const std::string& more) {
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= 20; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.,,1246\n", i + 1, i / 20.0);
  }
  for (int i = 1; i <= 20; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  }
  return text + "PBAR,1,1,1.2-4,3.6-10,3.6-10,7.2-10\n" +
         "MAT1,1,2.1+11,,.3,7850.\n" + more + "ENDDATA\n";
}

class HungFree : public ::testing::Test {
 protected:
  HungFree() {
    updating::BaseOptions options;
    options.high_hz = 100.0;
    options.split = false;
    options.points = {6 * 20 + 2};
    const updating::BaseBuilder builder(deck_, {}, options, Progress{});
    elastic_hz_ = builder.elastic_hz();
    context_.deck = &deck_;
    context_.mass_kg = builder.mass_kg();
    context_.low_hz = 20.0;
    context_.suspension = std::make_shared<const Suspension>(
        Suspension{hung_hz, builder.rigid_modes()});
  }

  [[nodiscard]] ParameterSpec spring(int node,
                                     const std::vector<double>& at = {}) const {
    return find("ground-spring")
        .parameters({.node = node, .at = at}, context_)
        .front();
  }

  structure::Deck deck_ = structure::deck_of(hung_text(""));
  TestContext context_;
  double elastic_hz_ = 0.0;
};

TEST_F(HungFree, TheStiffestSpringFollowsTheMassThatMovesThere) {
  const double at_middle = hung_kg * std::pow(two_pi * hung_hz, 2);
  // A bar's rotary inertia, some (6 mm / 1 m)^2, is all that differs.
  EXPECT_NEAR(spring(11).upper, at_middle, 1e-3 * at_middle);
  EXPECT_NEAR(spring(21).upper, at_middle / 4.0, 1e-3 * at_middle);
  EXPECT_NEAR(spring(16, {0.775, 0.0, 0.0}).upper,
              at_middle / (1.0 + 12.0 * 0.275 * 0.275),
              1e-3 * at_middle);
  EXPECT_LT(spring(21).lower, spring(21).start);
  EXPECT_LT(spring(21).start, spring(21).upper);
}

TEST_F(HungFree, TheStiffestSpringMakesARigidBodyModeOfThatFrequency) {
  const structure::Deck held = structure::deck_of(
      hung_text(fmt::format("CELAS2,901,{:.8g},21,3\n", spring(21).upper)));
  const structure::System system = structure::assemble(held);
  const structure::FreeMotions motions = structure::free_motions(system);
  const Eigen::VectorXd hz =
      structure::eigenmodes(
          motions.reduce(system.K), motions.reduce(system.M), 3)
          .frequency_hz;
  // The beam gives too: (1 Hz / 32 Hz)^2 of the frequency at most.
  EXPECT_NEAR(hz(1), hung_hz, 2e-3 * hung_hz);
  EXPECT_GT(hz(2), 30.0);
}

TEST_F(HungFree, NothingIsBoundWhereNothingIsKnown) {
  context_.suspension = nullptr;
  const double usual =
      10.0 * context_.mass_kg * std::pow(two_pi * context_.high_hz, 2);
  EXPECT_DOUBLE_EQ(spring(21).upper, usual);
}

TEST_F(HungFree, TheFirstElasticModeIsNoRigidOne) {
  EXPECT_EQ(context_.suspension->rigid.cols(), 2);
  // Euler-Bernoulli, free at both ends.
  const double b = 4.730040745;
  const double closed =
      b * b / two_pi * std::sqrt(2.1e11 * 3.6e-10 / 7850.0 / 1.2e-4);
  EXPECT_NEAR(elastic_hz_, closed, 2e-3 * closed);
}

}  // namespace
}  // namespace tapfit::effects
