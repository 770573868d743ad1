// What an effect does for a model, against the model with it switched off.
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

// A portal with a mass and two sensors that its deck does not know.
class FindEvidence : public ::testing::Test {
 protected:
  FindEvidence() {
    VirtualBundleSpec spec;
    spec.structure = "portal";
    spec.seed = 411;
    spec.points = 6;
    spec.hits = 2;
    spec.modulus_percent = 4.0;
    spec.effects = {parse_virtual_effect("added-mass@50=0.3")};
    make_virtual_bundle(spec, folder_.path() / "test");
    session_ = std::make_unique<Session>(folder_.path() / "test");
  }

  const EffectRef mass_ = parse_effect("added-mass@50");
  const EffectRef spring_ = parse_effect("ground-spring@20");
  ::tapfit::testing::TemporaryFolder folder_;
  std::unique_ptr<Session> session_;
};

TEST_F(FindEvidence, IsWhatSwitchingItOffLeaves) {
  session_->add_together({mass_, spring_});
  const double with = session_->comparison().error;
  const EffectEvidence found = session_->evidence(mass_);
  EXPECT_EQ(session_->effects().size(), 2U);
  EXPECT_TRUE(session_->effects()[0].on) << "the model stays as it is";
  EXPECT_EQ(session_->comparison().error, with);
  EXPECT_EQ(found.error_with, with);
  session_->toggle(0);
  EXPECT_EQ(found.error_without, session_->comparison().error);
  EXPECT_GT(found.error_without, 3.0 * with);
  ASSERT_TRUE(found.frf);
  EXPECT_EQ(found.without, session_->comparison().model_frfs[*found.frf]);
  // Of one that is off now, the same.
  EXPECT_EQ(session_->evidence(mass_).error_without, found.error_without);
}

TEST_F(FindEvidence, OfTheOnlyOneIsBesideWhatIsUncertain) {
  const EffectEvidence found = session_->evidence(mass_, {mass_});
  EXPECT_TRUE(session_->effects().empty());
  session_->add(mass_);
  ASSERT_EQ(session_->ladder().size(), 3U);
  EXPECT_NEAR(found.error_without, session_->ladder()[1].error, 1e-9);
  EXPECT_NEAR(found.error_with, session_->ladder()[2].error, 1e-9);
  const EffectEvidence modulus = session_->evidence({uncertain_rung, {}});
  EXPECT_NEAR(modulus.error_without, session_->ladder()[0].error, 1e-9);
  EXPECT_NEAR(modulus.error_with, session_->ladder()[1].error, 1e-9);
}

TEST_F(FindEvidence, RefusesAnEffectThatIsNotThere) {
  EXPECT_THROW((void)session_->evidence(spring_), InputError);
}

}  // namespace
}  // namespace tapfit::updating
