#include "updating/diagnosis/model_form.hpp"

#include "tests/updating/support/modal_bundle.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;

// A clamped steel bar, 0.5 m of 40 mm x 16 mm, that bends in z; `shear` is what
// stands in K1 and K2.
std::string thick_bar(const std::string& shear) {
  constexpr int bars = 20;
  constexpr double b = 0.04;
  constexpr double h = 0.016;
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= bars; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.,,1246\n", i + 1, 0.5 * i / bars);
  }
  for (int i = 1; i <= bars; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", i, i, i + 1);
  }
  text += fmt::format("PBAR,1,1,{},{},{},1e-7\n",
                      b * h,
                      b * h * h * h / 12.0,
                      h * b * b * b / 12.0);
  if (!shear.empty()) {
    text += fmt::format(",,,,,,,,,\n,{},{}\n", shear, shear);
  }
  return text + "MAT1,1,2.1+11,,.3,7850.\nSPC1,1,123456,1\nENDDATA\n";
}

class ModelFormTest : public ::testing::Test {
 protected:
  // A test of five modes of one bar with the deck of another.
  Session test(const std::string& truth, const std::string& deck) {
    const std::vector<Dof> points = {
        {6, 3, 1}, {9, 3, 1}, {13, 3, 1}, {17, 3, 1}, {21, 3, 1}};
    testing::write_modal_bundle(
        folder_,
        deck,
        testing::true_modes(truth, points, 5),
        points,
        {0.2, 2.0},
        R"(, "uncertain": [{"material": 1, "property": "E", "sd_percent": 3}])");
    return Session(folder_.path());
  }

  TemporaryFolder folder_;
};

TEST_F(ModelFormTest, NamesTheShearThatADeckLeavesOut) {
  Session session = test(thick_bar("0.83333"), thick_bar(""));
  const Diagnosis& d = session.diagnosis();
  EXPECT_EQ(d.verdict, "none");
  ASSERT_EQ(d.model_form.size(), 1U);
  const ModelForm& form = d.model_form.front();
  EXPECT_EQ(form.form, "section-shear");
  EXPECT_EQ(form.property, 1);
  EXPECT_GT(form.probability, 0.99);
  EXPECT_LE(form.share.lo95, 1.0);
  EXPECT_GE(form.share.hi95, 1.0);
  // Linear in the share: the fifth mode loses 5 %.
  EXPECT_NEAR(form.share.value, 1.0, 0.3);
  EXPECT_TRUE(form.card.starts_with("PBAR,1,1,0.00064,")) << form.card;
}

TEST_F(ModelFormTest, SaysNothingWhereTheDeckIsRight) {
  for (const std::string shear : {"", "0.83333"}) {
    Session session = test(thick_bar(shear), thick_bar(shear));
    EXPECT_TRUE(session.diagnosis().model_form.empty()) << shear;
    EXPECT_EQ(session.diagnosis().verdict, "none");
  }
}

// The updated deck shears as much, in fields that its card did not have.
TEST_F(ModelFormTest, StandsInTheUpdatedDeck) {
  Session session = test(thick_bar("0.83333"), thick_bar(""));
  session.fit_uncertain();
  const std::vector<ModelForm> form = session.model_form();
  ASSERT_EQ(form.size(), 1U);
  write_updated_deck(session, folder_.path() / "updated.bdf", {});
  const structure::Deck written =
      structure::read_deck(folder_.path() / "updated.bdf");
  EXPECT_NEAR(written.bar_properties.at(1).K1,
              5.0 / 6.0 / form.front().share.value,
              1e-6);
  EXPECT_EQ(written.bar_properties.at(1).K2, written.bar_properties.at(1).K1);
  EXPECT_NEAR(written.bar_properties.at(1).area, 0.00064, 1e-9);
}

}  // namespace
}  // namespace tapfit::updating
