// Supports that the deck lacks, screened through the modes of the free plate.
#include "updating/search/screen_clamps.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/places/held_support.hpp"
#include "updating/search/screening.hpp"
#include "updating/search/worth_fitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

Location left_end(const std::string& how) {
  Location where;
  where.nodes = {1, 12, 23, 34, 45};
  where.variant = how;
  return where;
}

// A test of a plate whose deck hangs free.
class FreeDeck {
 public:
  explicit FreeDeck(const std::vector<EffectInstance>& hidden)
      : test_(hidden, 0.02, 13, 0.008, false),
        fit_(test_.fitter().fit({}, test_.fitter().model_for({}))) {}

  // What a base is built for.
  [[nodiscard]] std::vector<Location> asked_for() const {
    const std::vector<Screened> all = screen(fit_, test_.fitter(), {});
    const Reach reach(fit_, test_.fitter());
    std::vector<Location> places;
    for (const Planned& plan :
         planned_fits(fit_, all, test_.fitter(), HypothesisOptions{}, reach)) {
      for (const EffectInstance& tried : plan.tries) {
        if (is_held(tried.where)) places.push_back(tried.where);
      }
    }
    return places;
  }

  [[nodiscard]] ProjectedMisfit misfit() const {
    return {anywhere(), target()};
  }

  [[nodiscard]] std::vector<Screened> screened() const {
    const Fit fit = anywhere();
    return screen_clamps(
        fit,
        test_.fitter(),
        target(),
        misfit(),
        fit.model->respond(fit.result.state, target().s, false).H);
  }

 private:
  [[nodiscard]] const Target& target() const {
    return test_.fitter().problem().targets.front();
  }
  // Its model may be asked about any grid.
  [[nodiscard]] Fit anywhere() const {
    Fit fit = fit_;
    fit.model = test_.fitter().model_for({}, BaseUse::Scan);
    return fit;
  }

  PlateExperiment test_;
  Fit fit_;
};

TEST(ScreenClamps, AsksForAFewBasesAndTheRightOneAmongThem) {
  for (const char* how : {"held", "held-translations"}) {
    const Location end = left_end(how);
    const FreeDeck test({{&effects::find("support-mismatch"), end, {}}});
    const std::vector<Location> places = test.asked_for();
    EXPECT_EQ(std::ranges::count(places, end), 1) << how;
    EXPECT_LE(places.size(), 2U) << "of 22";
  }
}

// Its corners alone hold nearly as well; no other place does.
TEST(ScreenClamps, PutsTheEndThatWasHeldFirst) {
  const FreeDeck test(
      {{&effects::find("support-mismatch"), left_end("held"), {}}});
  const std::vector<Screened> all = test.screened();
  ASSERT_EQ(all.size(), 22U);
  const auto at_end = [](const Screened& s) {
    return std::ranges::all_of(s.placed.where.nodes, [](int node) {
      return std::ranges::count(left_end("held").nodes, node) > 0;
    });
  };
  EXPECT_TRUE(at_end(all[0]));
  EXPECT_TRUE(at_end(all[1]));
  const auto other = std::ranges::find_if_not(all, at_end);
  ASSERT_NE(other, all.end());
  EXPECT_LT(all[0].error, 0.7 * other->error);
}

TEST(ScreenClamps, AsksForNoneWhereTheTestWasFreeAsWell) {
  EXPECT_TRUE(FreeDeck({}).asked_for().empty());
  Location grid;
  grid.node = 30;
  const FreeDeck loaded({{&effects::find("added-mass"), grid, {0.03}}});
  EXPECT_TRUE(loaded.asked_for().empty());
}

TEST(ScreenClamps, OfPromisingOnesStandForAll) {
  const FreeDeck test(
      {{&effects::find("support-mismatch"), left_end("held"), {}}});
  const std::vector<Screened> all = test.screened();
  const ProjectedMisfit misfit = test.misfit();
  const std::vector<Screened> few = promising_clamps(all, misfit);
  ASSERT_EQ(few.size(), 2U);
  EXPECT_EQ(few[0].placed.where, all[0].placed.where);
  EXPECT_EQ(few[0].places, 11.0);
  for (const Screened& s : few) {
    EXPECT_LT(s.error, worth_it * misfit.unchanged());
  }
}

}  // namespace
}  // namespace tapfit::updating
