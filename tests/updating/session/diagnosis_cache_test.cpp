// A diagnosis is kept under all that it follows from: of a test that consists
// of modes their points and the pairs set by hand, too.
#include "updating/session/diagnosis_cache.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

class KeptDiagnosis : public ::testing::Test {
 protected:
  KeptDiagnosis() {
    folder_.write("test.json", "{}");
    bundle_.folder = folder_.path();
    bundle_.modes.emplace();
    modes_.dofs = {{12, 3, 1}, {14, 3, 1}};
    modes_.modes.resize(1);
    modal::set_pole(modes_.modes[0], 10.0, 0.01);
    modes_.modes[0].shape = Eigen::Vector2cd(1.0, 2.0);
  }

  [[nodiscard]] DiagnosisCache diagnosis_cache() const {
    return {MatrixCache{folder_.path() / "cache"},
            {bundle_, deck_, frfs_, modes_, pairs_},
            {},
            0};
  }
  void keep() const {
    Diagnosis diagnosis;
    diagnosis.verdict = "none";
    diagnosis_cache().keep(diagnosis);
  }

  tapfit::testing::TemporaryFolder folder_;
  acquisition::TestBundle bundle_;
  structure::Deck deck_;
  signal::FrfSet frfs_;
  modal::ModeSet modes_;
  std::vector<PairByHand> pairs_;
};

TEST_F(KeptDiagnosis, IsFoundAgainWhereNothingChanged) {
  EXPECT_FALSE(diagnosis_cache().load());
  keep();
  const auto kept = diagnosis_cache().load();
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->verdict, "none");
}

TEST_F(KeptDiagnosis, IsNotThatOfShapesAtOtherPoints) {
  keep();
  modes_.dofs[1].node = 15;
  EXPECT_FALSE(diagnosis_cache().load());
  modes_.dofs[1] = {14, 2, 1};
  EXPECT_FALSE(diagnosis_cache().load());
}

TEST_F(KeptDiagnosis, IsOfThePairsWhereModesAreTheData) {
  keep();
  pairs_ = {{10.0, 1}};
  EXPECT_FALSE(diagnosis_cache().load());
  keep();
  pairs_[0].model = 2;
  EXPECT_FALSE(diagnosis_cache().load());
  // FRFs are compared without pairs.
  bundle_.modes.reset();
  keep();
  pairs_.clear();
  EXPECT_TRUE(diagnosis_cache().load());
}

}  // namespace
}  // namespace tapfit::updating
