#include "updating/session/weighed_mass.hpp"

#include "tests/support/matchers.hpp"
#include "tests/updating/support/clamped_beam.hpp"
#include "updating/session/session.hpp"
#include "updating/test_check/test_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

acquisition::TestBundle weighed(double kg) {
  acquisition::TestBundle bundle;
  bundle.weighed = acquisition::Weighed{kg, {}, 1.0};
  return bundle;
}

TEST(WeighedMass, BesideTheDecksIsSaidWithBothAndTheirRatio) {
  const auto found = weighed_mass_finding(weighed(4.0), 1.24);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->what,
              HasSubstr("weighed at 4 kg, 3.23 times the 1.24 kg"));
  EXPECT_FALSE(weighed_mass_finding(weighed(1.27), 1.24));
  EXPECT_FALSE(weighed_mass_finding({}, 1.24));
  EXPECT_FALSE(weighed_mass_finding(weighed(4.0), 0.0));
}

TEST(WeighedMass, OfAnUncertainDensityMayDifferByThreeDeviations) {
  acquisition::TestBundle bundle = weighed(1.15);
  EXPECT_TRUE(weighed_mass_finding(bundle, 1.0));
  bundle.uncertain = {{"material", 1, "E", 10.0}};
  EXPECT_TRUE(weighed_mass_finding(bundle, 1.0));
  bundle.uncertain = {{"material", 1, "rho", 6.0}};
  EXPECT_FALSE(weighed_mass_finding(bundle, 1.0));
}

TEST(WeighedMass, InAnotherUnitIsNamed) {
  EXPECT_THAT(weighed_mass_finding(weighed(2.205), 1.0)->likely,
              HasSubstr("lb for kg"));
  EXPECT_THAT(weighed_mass_finding(weighed(0.00124), 1.24)->likely,
              HasSubstr("1000: g or t for kg"));
}

// By the check alone, which fits nothing.
TEST(WeighedMass, IsComparedByTheCheckOfATest) {
  const std::vector<Dof> points = testing::beam_points();
  const double kg = 7850.0 * testing::beam_area;  // of 1 m
  for (const double share : {1.0, 3.0}) {
    const tapfit::testing::TemporaryFolder folder;
    testing::write_modal_bundle(
        folder,
        testing::beam_text(),
        testing::clamped_beam(points),
        points,
        {},
        fmt::format(", \"weighed\": {{\"mass_kg\": {}}}", share * kg));
    Session session(folder.path());
    const TestCheck check = check_test(session, {}, {});
    EXPECT_EQ(std::ranges::count_if(check.findings,
                                    [](const Finding& f) {
                                      return f.what.find("was weighed at") !=
                                             std::string::npos;
                                    }),
              share > 1.0 ? 1 : 0);
  }
}

}  // namespace
}  // namespace tapfit::updating
