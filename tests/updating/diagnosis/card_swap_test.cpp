// A wooden plate whose deck has its moduli exchanged.
#include "updating/diagnosis/card_swap.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/search/screened.hpp"
#include "updating/search/slip_fits.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace tapfit::updating {
namespace {

structure::Deck wooden_plate(double E1, double E2) {
  structure::Deck deck = support::plate_deck(true);
  structure::Material& spruce = deck.materials[1];
  spruce.orthotropic = true;
  spruce.E = E1;
  spruce.E2 = E2;
  spruce.nu = 0.05;
  spruce.G = 0.7e9;
  spruce.rho = 430.0;
  return deck;
}

class CardSwap : public ::testing::Test {
 protected:
  // FRFs of the first deck with 1 % of noise, to be fitted by the second.
  void measure(const structure::Deck& truth, const structure::Deck& written) {
    deck_ = written;
    const BaseBuilder real(
        truth, bundle_.uncertain, support::plate_base(bundle_, truth), {});
    FitProblem fit;
    fit.context = support::plate_context(bundle_, truth);
    fit.uncertain_sd = {0.03};
    fit.damping_ratio = 0.008;
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const double delta : {0.06, 0.03}) {
      const Eigen::VectorXcd s = damped_line({10.0, 400.0}, 3.0, {delta, 120});
      fit.measured = support::plate_pairs(bundle_, s);
      fit.targets.push_back(make_target(fit.measured));
      const Fitter fitter(real, fit);
      const auto model = fitter.model_for({});
      const Eigen::MatrixXcd H =
          model->respond(fitter.first_state(*model, {}), s, false).H;
      const Eigen::VectorXd level =
          0.01 * H.cwiseAbs2().rowwise().mean().cwiseSqrt();
      for (std::size_t f = 0; f < fit.measured.frfs.size(); ++f) {
        signal::Frf& frf = fit.measured.frfs[f];
        frf.H = H.col(static_cast<Eigen::Index>(f));
        for (Eigen::Index l = 0; l < s.size(); ++l) {
          frf.H(l) +=
              level(l) * std::complex<double>(normal(random), normal(random));
        }
        frf.variance = 2.0 * level.cwiseAbs2();
      }
      fit.targets.back() = make_target(fit.measured);
    }
    fit.context = support::plate_context(bundle_, deck_);
    builder_.emplace(deck_,
                     bundle_.uncertain,
                     support::plate_base(bundle_, deck_),
                     Progress{});
    fitter_.emplace(*builder_, fit);
  }

  [[nodiscard]] std::optional<SetUpMistake> found() const {
    return likely_slip(*fitter_, {});
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
  structure::Deck deck_;
  std::optional<BaseBuilder> builder_;
  std::optional<Fitter> fitter_;
};

TEST_F(CardSwap, OfExchangedModuliIsFound) {
  measure(wooden_plate(11e9, 0.8e9), wooden_plate(0.8e9, 11e9));
  const SlipFits screened = screen_slips(*fitter_, card_slips(deck_), {});
  ASSERT_EQ(screened.slips.size(), 3U);
  // The deck's vectors are short of what the moduli exchanged make of them.
  EXPECT_LT(screened.slips[0].error, worth_it * screened.plain.error);
  const SlipFits fits = fit_slips(*fitter_, card_slips(deck_), {});
  ASSERT_EQ(fits.slips.size(), 3U);
  // The noise, of 1 % in either part.
  EXPECT_LT(fits.slips[0].error, 0.03);
  EXPECT_GT(fits.plain.error, 0.3);
  const auto slip = found();
  ASSERT_TRUE(slip);
  EXPECT_EQ(slip->mistake, "card-swap");
  EXPECT_EQ(slip->edit, "model: MAT8 1, exchange E1 and E2");
  EXPECT_EQ(slip->where.elements.size(), deck_.shells.size());
  EXPECT_GT(slip->probability, 0.99);
}

TEST_F(CardSwap, OfHalfTheThicknessIsFoundFromFrfs) {
  const structure::Deck truth = wooden_plate(11e9, 0.8e9);
  structure::Deck half = truth;
  half.shell_properties[1].thickness *= 0.5;
  measure(truth, half);
  const auto slip = found();
  ASSERT_TRUE(slip);
  EXPECT_EQ(slip->where.variant, "T-times-2");
  EXPECT_LT(slip->error, 0.03);
  EXPECT_FALSE(is_out_of_scale(*slip, deck_));
}

// Psi make the modulus of steel, too: the measurement tells.
TEST_F(CardSwap, OfAModulusInAnotherUnitIsFound) {
  const structure::Deck truth = support::plate_deck(true);
  structure::Deck in_MPa = truth;
  in_MPa.materials[1].E *= 1e-6;
  in_MPa.materials[1].G *= 1e-6;
  measure(truth, in_MPa);
  ASSERT_GT(card_slips(deck_).size(), 3U);
  const auto slip = found();
  ASSERT_TRUE(slip);
  EXPECT_EQ(slip->where.variant, "E-in-MPa");
  EXPECT_EQ(slip->edit, "model: material 1, E from MPa to SI");
  EXPECT_LT(slip->error, 0.03);
  EXPECT_TRUE(is_out_of_scale(*slip, deck_));
}

TEST(DeckSlip, ExplainsAllOrLeavesLess) {
  EXPECT_TRUE(explains_all(0.05, 0.8, 0.02));
  EXPECT_FALSE(explains_all(0.05, 0.8, 0.01));
  EXPECT_FALSE(explains_all(0.05, 0.1, 0.02));
  SetUpMistake slip;
  slip.error = 0.05;
  Diagnosis found;
  found.error_fitted = 0.8;
  EXPECT_TRUE(leaves_less(slip, found));
  EXPECT_TRUE(none_explains(found, 0.02));
  EXPECT_FALSE(none_explains(found, 0.3));
  found.candidates.emplace_back();
  found.candidates.back().error = 0.055;
  EXPECT_FALSE(leaves_less(slip, found));
  EXPECT_FALSE(none_explains(found, 0.02));
}

TEST_F(CardSwap, IsNoneWhereTheCardsAreRight) {
  const structure::Deck deck = wooden_plate(11e9, 0.8e9);
  measure(deck, deck);
  EXPECT_FALSE(found());
  // None is worth a base.
  const SlipFits screened = screen_slips(*fitter_, card_slips(deck_), {});
  ASSERT_EQ(screened.slips.size(), 3U);
  for (const SlipFit& slip : screened.slips) {
    EXPECT_GT(slip.error, screened.plain.error) << slip.edit;
  }
}

}  // namespace
}  // namespace tapfit::updating
