#include "updating/diagnosis/model_form.hpp"

#include "tests/support/matchers.hpp"
#include "tests/updating/support/based_frame.hpp"
#include "tests/updating/support/modal_bundle.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

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
  write_updated_deck(session, folder_.path() / "updated.bdf", {}, {});
  const structure::Deck written =
      structure::read_deck(folder_.path() / "updated.bdf");
  EXPECT_NEAR(written.bar_properties.at(1).K1,
              5.0 / 6.0 / form.front().share.value,
              1e-6);
  EXPECT_EQ(written.bar_properties.at(1).K2, written.bar_properties.at(1).K1);
  EXPECT_NEAR(written.bar_properties.at(1).area, 0.00064, 1e-9);
}

constexpr std::size_t shear_at = 2;  // behind E and the mesh
constexpr std::size_t corner_at = 3;
constexpr std::size_t mass_at = 4;

// A fit that ended with these ln f, each known to sd.
class ToldForm : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    frame_ = std::make_unique<support::BasedFrame>();
    const effects::TestContext context = frame_->context();
    model_ = std::make_shared<FrfModel>(
        frame_->builder.build({}, {}), context, signal::FrfSet{});
  }
  static void TearDownTestSuite() {
    model_.reset();
    frame_.reset();
  }

  static Fit fit_of(double shear, double corner, double sd, double mass = 0.0) {
    Fit fit;
    fit.model = model_;
    fit.result.state.factor = {
        1.0, 1.0, std::exp(shear), std::exp(corner), std::exp(mass)};
    fit.result.covariance = sd * sd * Eigen::MatrixXd::Identity(5, 5);
    fit.result.error = 0.012;
    return fit;
  }

  static const Correction& before(std::size_t factor) {
    return frame_->corrections.at(factor - 1);
  }

  // ln f at which the density at 0 is that many times less after the data than
  // before them; both are normal.
  static double ln_factor_for(double ratio, double sd, const Correction& c) {
    const double z = c.mean / c.sd;
    return sd * std::sqrt(z * z + 2.0 * std::log(ratio * c.sd / sd));
  }

  static std::vector<ModelForm> told(double shear, double corner, double sd) {
    return model_form(fit_of(shear, corner, sd), frame_->deck);
  }

  static inline std::unique_ptr<support::BasedFrame> frame_;
  static inline std::shared_ptr<const FrfModel> model_;
};

// Savage's ratio of 20 is the limit.
TEST_F(ToldForm, IsToldWhereTheDataExcludeTheDeckAsItStands) {
  ASSERT_EQ(before(shear_at).name, "section-shear");
  ASSERT_EQ(before(corner_at).name, "corner-stiffness");
  for (const double sd : {0.05, 0.15}) {
    const double shear = ln_factor_for(21.0, sd, before(shear_at));
    const double corner = ln_factor_for(21.0, sd, before(corner_at));
    const double less_shear = ln_factor_for(19.0, sd, before(shear_at));
    const double less_corner = ln_factor_for(19.0, sd, before(corner_at));
    EXPECT_TRUE(told(less_shear, less_corner, sd).empty()) << sd;
    const std::vector<ModelForm> one = told(shear, less_corner, sd);
    ASSERT_EQ(one.size(), 1U) << sd;
    EXPECT_EQ(one[0].form, "section-shear");
    EXPECT_NEAR(one[0].probability, 21.0 / 22.0, 1e-9);
    const std::vector<ModelForm> other = told(less_shear, corner, sd);
    ASSERT_EQ(other.size(), 1U) << sd;
    EXPECT_EQ(other[0].form, "corner-stiffness");
    EXPECT_NEAR(other[0].probability, 21.0 / 22.0, 1e-9);
    EXPECT_EQ(told(shear, corner, sd).size(), 2U);
  }
}

// As far as the prior expects it, but no better known than before; and the
// other way from the deck, which no form is.
TEST_F(ToldForm, IsNotToldWhereTheDataSayNothingOfIt) {
  EXPECT_TRUE(
      told(before(shear_at).mean, before(corner_at).mean, 0.35).empty());
  EXPECT_TRUE(told(0.0, 0.0, 0.01).empty());
  EXPECT_TRUE(told(-0.5, -0.5, 0.01).empty());
  Fit unknown = fit_of(0.7, 0.4, 0.01);
  unknown.result.covariance.resize(0, 0);
  EXPECT_TRUE(model_form(unknown, frame_->deck).empty());
  // So sure that the ratio is beyond all numbers.
  const std::vector<ModelForm> sure = told(0.7, 0.4, 1e-3);
  ASSERT_EQ(sure.size(), 2U);
  EXPECT_EQ(sure[0].probability, 1.0);
}

// Quantiles of a log-normal variable; K1 = 5/6 over the share. Elements 8 and 9
// meet at the corner.
TEST_F(ToldForm, HoldsSizeCardAndElements) {
  const double t = std::log(1.0 + 0.8);
  const std::vector<ModelForm> both = told(t, std::log(1.5), 0.05);
  ASSERT_EQ(both.size(), 2U);
  const ModelForm& shear = both[0];
  EXPECT_EQ(shear.property, 1);
  EXPECT_TRUE(shear.elements.empty());
  EXPECT_NEAR(shear.share.value, 0.8, 1e-12);
  EXPECT_NEAR(shear.share.sd, 1.8 * 0.05, 1e-12);
  EXPECT_NEAR(shear.share.lo95, std::exp(t - 1.96 * 0.05) - 1.0, 1e-12);
  EXPECT_NEAR(shear.share.hi95, std::exp(t + 1.96 * 0.05) - 1.0, 1e-12);
  EXPECT_EQ(shear.error, 0.012);
  EXPECT_THAT(statement(shear), HasSubstr("PBAR 1 has no K1 and K2"));
  EXPECT_THAT(statement(shear), HasSubstr("0.8 (0.63 to 0.99; p = 1.00)"));
  const ModelForm& corner = both[1];
  EXPECT_EQ(corner.elements, (std::vector<int>{8, 9}));
  EXPECT_NEAR(corner.share.value, 0.5, 1e-12);
  EXPECT_TRUE(corner.card.empty());
  EXPECT_THAT(statement(corner), HasSubstr("up to each other's face"));
}

// The whole structure's: no card and no element of its own.
TEST_F(ToldForm, SaysThatMassLiesOnLines) {
  ASSERT_EQ(before(mass_at).name, "line-mass");
  const std::vector<ModelForm> form =
      model_form(fit_of(0.0, 0.0, 0.05, std::log(2.0)), frame_->deck);
  ASSERT_EQ(form.size(), 1U);
  EXPECT_EQ(form[0].form, "line-mass");
  EXPECT_NEAR(form[0].share.value, 1.0, 1e-12);
  EXPECT_EQ(form[0].property, 0);
  EXPECT_TRUE(form[0].elements.empty());
  EXPECT_TRUE(form[0].card.empty());
  EXPECT_THAT(statement(form[0]), HasSubstr("mass on lines"));
}

// In the place of the deck's own card it is the same section that shears.
TEST_F(ToldForm, HasACardInTheUnitsOfTheFile) {
  const Fit fit = fit_of(std::log(1.8), 0.0, 0.05);
  for (const bool in_mm : {false, true}) {
    const support::DeckUnits units =
        in_mm ? support::mm_t_s : support::DeckUnits{};
    const char* name = in_mm ? "mm-t-s" : "SI";
    std::string text = support::frame_text(units);
    const structure::Deck deck = support::frame_deck(text, name);
    const std::vector<ModelForm> form = model_form(fit, deck);
    ASSERT_EQ(form.size(), 1U);
    const std::size_t at = text.find("PBAR,1,");
    text.replace(at, text.find('\n', at) - at, form[0].card);
    const structure::Deck mended = support::frame_deck(text, name);
    const structure::BarProperty& is = mended.bar_properties.at(1);
    const structure::BarProperty& was = frame_->deck.bar_properties.at(1);
    constexpr double digits = 5e-4;  // of four that K1 is written with
    EXPECT_NEAR(is.K1, 5.0 / 6.0 / 0.8, digits * is.K1);
    EXPECT_EQ(is.K2, is.K1);
    EXPECT_NEAR(is.area, was.area, digits * was.area) << name;
    EXPECT_NEAR(is.I1, was.I1, digits * was.I1) << name;
    EXPECT_NEAR(is.I2, was.I2, digits * was.I2) << name;
    EXPECT_NEAR(is.J, was.J, digits * was.J) << name;
    EXPECT_EQ(is.material, was.material);
  }
}

}  // namespace
}  // namespace tapfit::updating
