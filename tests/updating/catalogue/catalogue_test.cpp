#include "updating/catalogue/catalogue.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace tapfit::effects {
namespace {

class EveryEffect : public ::testing::Test {
 protected:
  EveryEffect()
      : deck_(support::plate_deck(true)),
        bundle_(support::plate_bundle()),
        context_(support::plate_context(bundle_, deck_)) {}

  structure::Deck deck_;
  acquisition::TestBundle bundle_;
  TestContext context_;
};

TEST_F(EveryEffect, HasANameOfItsOwn) {
  std::set<std::string> names;
  std::set<std::string> words;
  for (const Effect* effect : catalogue()) {
    names.insert(effect->name());
    words.insert(effect->words());
    EXPECT_FALSE(effect->words().empty()) << effect->name();
  }
  EXPECT_EQ(names.size(), catalogue().size());
  EXPECT_EQ(words.size(), catalogue().size());
}

TEST_F(EveryEffect, HasItsPage) {
  const std::filesystem::path pages =
      std::filesystem::path(TAPFIT_SOURCE_DIR) / "docs" / "effects";
  for (const Effect* effect : catalogue()) {
    EXPECT_TRUE(std::filesystem::exists(pages / (effect->name() + ".md")))
        << effect->name();
  }
}

TEST_F(EveryEffect, HasAPlaceOnAClampedPlate) {
  for (const Effect* effect : catalogue()) {
    EXPECT_FALSE(effect->places(context_).empty()) << effect->name();
  }
}

TEST_F(EveryEffect, StartsWithinItsBounds) {
  for (const Effect* effect : catalogue()) {
    const Location where = effect->places(context_).front();
    for (const ParameterSpec& spec : effect->parameters(where, context_)) {
      EXPECT_GT(spec.lower, 0.0) << effect->name() << ' ' << spec.name;
      EXPECT_GE(spec.start, spec.lower) << effect->name() << ' ' << spec.name;
      EXPECT_LE(spec.start, spec.upper) << effect->name() << ' ' << spec.name;
    }
  }
}

TEST_F(EveryEffect, LawsAgreeWithTheirDerivatives) {
  const std::complex<double> s(40.0, 900.0);
  for (const Effect* effect : catalogue()) {
    const Location where = effect->places(context_).front();
    std::vector<double> p;
    for (const ParameterSpec& spec : effect->parameters(where, context_)) {
      p.push_back(spec.start);
    }
    // Only faults of a channel have a second law: that of the hammer.
    const std::size_t groups = effect->entry() == Entry::Measurement ? 2 : 1;
    for (std::size_t group = 0; group < groups; ++group) {
      for (std::size_t k = 0; k < p.size(); ++k) {
        const double h = 1e-6 * p[k];
        std::vector<double> up = p;
        std::vector<double> down = p;
        up[k] += h;
        down[k] -= h;
        const std::complex<double> numeric =
            (effect->law(s, up, group) - effect->law(s, down, group)) /
            (2.0 * h);
        const std::complex<double> analytic =
            effect->law_derivative(s, p, group, k);
        // Central differences of relative step 1e-6 are good to about 1e-9.
        EXPECT_LE(std::abs(numeric - analytic), 1e-7 * std::abs(analytic))
            << effect->name() << " group " << group << " parameter " << k;
      }
    }
  }
}

// One mass for each channel, and a mass with its inertia: s^2 p_k each.
TEST_F(EveryEffect, MassesHaveALawEach) {
  const std::complex<double> s(40.0, 900.0);
  const std::vector<double> p = {0.02, 0.05};
  for (const char* name : {"sensor-mass", "added-mass"}) {
    const Effect& mass = find(name);
    for (const std::size_t k : {0U, 1U}) {
      // Rounding.
      EXPECT_LT(std::abs(mass.law(s, p, k) / (s * s) - p[k]), 1e-15) << name;
      EXPECT_LT(std::abs(mass.law_derivative(s, p, k, k) / (s * s) - 1.0),
                1e-14)
          << name;
      EXPECT_EQ(mass.law_derivative(s, p, k, 1 - k), 0.0) << name;
    }
  }
}

TEST_F(EveryEffect, HasCardsOrAComment) {
  for (const Effect* effect : catalogue()) {
    const Location where = effect->places(context_).back();
    std::vector<double> p;
    for (const ParameterSpec& spec : effect->parameters(where, context_)) {
      p.push_back(spec.start);
    }
    EXPECT_FALSE(effect->bulk_data(where, context_, p).empty())
        << effect->name();
  }
}

// Well below its own frequency an absorber is its mass, well above it a spring
// (to ground, because its mass stands still).
TEST_F(EveryEffect, AbsorberIsAMassBelowAndASpringAbove) {
  const Effect& absorber = find("absorber");
  const std::vector<double> p = {0.05, 100.0, 0.001};
  const double w = 2.0 * M_PI * 100.0;
  const std::complex<double> low(0.0, 0.01 * w);
  EXPECT_NEAR((absorber.law(low, p, 0) / (low * low)).real(), 0.05, 1e-5);
  const std::complex<double> high(0.0, 100.0 * w);
  const double k = 0.05 * w * w;
  EXPECT_NEAR(absorber.law(high, p, 0).real(), k, 1e-3 * k);
}

TEST_F(EveryEffect, HammerFaultsAreTheInverseOfSensorFaults) {
  const std::complex<double> s(1.0, 300.0);
  for (const char* name : {"channel-gain", "channel-delay"}) {
    const Effect& effect = find(name);
    const std::complex<double> both =
        effect.law(s, {0.002}, 0) * effect.law(s, {0.002}, 1);
    EXPECT_NEAR(std::abs(both - 1.0), 0.0, 1e-12) << name;
  }
}

// An early sensor is a late hammer as far as one FRF can tell, and is said to
// have a negative delay.
TEST_F(EveryEffect, EarlyChannelsHaveNegativeDelay) {
  const Effect& delay = find("channel-delay");
  const std::vector<Location> places = delay.places(context_);
  const auto early =
      std::count_if(places.begin(), places.end(), [](const Location& where) {
        return where.variant == "early";
      });
  EXPECT_EQ(2 * early, static_cast<std::ptrdiff_t>(places.size()));
  const Location& last = places.back();
  const Location& first = places.front();
  EXPECT_EQ(delay.passed_as(first, false), 0U);
  EXPECT_EQ(delay.passed_as(first, true), 1U);
  EXPECT_EQ(delay.passed_as(last, false), 1U);
  EXPECT_EQ(delay.passed_as(last, true), 0U);
  EXPECT_EQ(delay.parameters(first, context_)[0].sign, 1.0);
  EXPECT_EQ(delay.parameters(last, context_)[0].sign, -1.0);
}

// Cards go into the engineer's file: in millimetres and tonnes a stiffness is
// in N/mm, one of a rotation in N mm.
TEST_F(EveryEffect, CardsAreInTheUnitsOfTheFile) {
  structure::Deck deck = deck_;
  deck.file_length_m = 1e-3;
  deck.file_mass_kg = 1e3;
  EXPECT_TRUE(point_mass_card(deck, 0, 30, 0.02).ends_with(",2.000000e-05"));
  EXPECT_NE(ground_spring_cards(deck, 0, 30, 3, 5e3).front().find(",5.000000,"),
            std::string::npos);
  EXPECT_NE(ground_spring_cards(deck, 0, 30, 5, 5.0).front().find(",5000.000,"),
            std::string::npos);
  // Grid 11 is the corner at x = 0.3 m.
  EXPECT_NE(absorber_cards(deck, 11, 3, 0.1, 1e4, 1.0).front().find("300.0000"),
            std::string::npos);
  deck.weight_to_mass = 0.5;
  EXPECT_TRUE(point_mass_card(deck, 0, 30, 0.02).ends_with(",4.000000e-05"));
}

// What a mass with an inertia adds to the deck is read back as it was.
TEST_F(EveryEffect, InertiaIsReadBack) {
  structure::Deck deck = deck_;
  deck.file_length_m = 1e-3;
  deck.file_mass_kg = 1e3;
  const std::string card = point_mass_card(deck, 0, 30, 0.02, 3e-5);
  EXPECT_NE(card.find('\n'), std::string::npos);
  const std::string text =
      "GRID,30,,0.,0.,0.\nGRID,31,,1.,0.,0.\n" + card + "\nENDDATA\n";
  const structure::Deck read = structure::deck_of(text);
  ASSERT_EQ(read.masses.size(), 1U);
  // Numbers of 7 digits, here in tonnes and millimetres.
  EXPECT_NEAR(read.masses[0].mass, 2e-5, 1e-11);
  EXPECT_NEAR(read.masses[0].inertia(0, 0), 3e-2, 1e-8);
  EXPECT_NEAR(read.masses[0].inertia(2, 2), 3e-2, 1e-8);
  EXPECT_EQ(read.masses[0].inertia(1, 0), 0.0);
}

// Three channels of one sensor carry one mass.
TEST_F(EveryEffect, TriaxialSensorIsOneMass) {
  acquisition::Channel side;
  side.name = "acc1y";
  bundle_.channels.push_back(side);
  for (acquisition::Run& run : bundle_.runs) {
    run.sensors.push_back({3, {11, 2, 1}});
  }
  const Effect& effect = find("sensor-mass");
  const Location all = effect.places(context_).front();
  ASSERT_EQ(all.channels.size(), 3U);
  const std::vector<InterfaceDof> acted =
      effect.interface_dofs(all, context_, 0);
  const auto at = std::count_if(acted.begin(),
                                acted.end(),
                                [](const auto& dof) { return dof.node == 11; });
  EXPECT_EQ(at, 3);  // x, y and z, once each
}

TEST(Find, SaysWhichEffectWasMeant) {
  try {
    static_cast<void>(find("joit"));
    ADD_FAILURE() << "there is a joit";
  } catch (const InputError& fault) {
    EXPECT_TRUE(fault.remedy().starts_with("did you mean joint? use one of "))
        << fault.remedy();
  }
}

}  // namespace
}  // namespace tapfit::effects
