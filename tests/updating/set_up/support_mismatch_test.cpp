#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/plate_model.hpp"
#include "updating/places/held_support.hpp"
#include "updating/set_up/mistakes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::effects {
namespace {

using updating::EffectInstance;

// The clamped plate, its corner 55 held along an axis between Y and Z as well.
class TurnedSupport : public updating::PlateModel {
 protected:
  TurnedSupport() {
    held_.grids[held_.grid_index(55)].axes =
        Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
    held_.constraints.push_back({55, "3"});
    corner_.nodes = {55};
    corner_.variant = "free";
  }

  [[nodiscard]] TestContext context() const {
    return support::plate_context(bundle_, held_);
  }
  [[nodiscard]] Eigen::MatrixXcd frfs(
      const structure::Deck& deck,
      const std::vector<EffectInstance>& effects) const {
    updating::FitProblem fit = fitter_->problem();
    fit.context = support::plate_context(bundle_, deck);
    const updating::BaseBuilder builder(deck,
                                        bundle_.uncertain,
                                        support::plate_base(bundle_, deck),
                                        Progress{});
    const updating::Fitter fitter(builder, fit);
    const auto model = fitter.model_for(effects);
    return model->respond(fitter.first_state(*model, effects), s_, false).H;
  }

  structure::Deck held_ = support::plate_deck(true);
  Location corner_;
};

TEST_F(TurnedSupport, IsFreeOfWhatItHoldsAlongItsOwnAxes) {
  const std::vector<Location> places = support_mismatch().places(context());
  EXPECT_EQ(std::ranges::count(places, corner_), 1);
  const auto released = support_mismatch().released(corner_, context());
  ASSERT_EQ(released.size(), 1U);
  EXPECT_EQ(released[0].grid, 55);
  EXPECT_EQ(released[0].components, "3");
  Location along = corner_;
  along.variant = "free-Z";
  EXPECT_EQ(std::ranges::count(places, along), 0) << "none of its axes";
}

TEST_F(TurnedSupport, FreedIsThePlateWithoutIt) {
  const Eigen::MatrixXcd plain = frfs(deck_, {});
  const Eigen::MatrixXcd held = frfs(held_, {});
  EXPECT_GT(updating::difference(held, plain), 0.1);
  const EffectInstance free{&find("support-mismatch"), corner_, {}};
  // Static answers bring both bases to about 1e-6 of each other.
  EXPECT_LT(updating::difference(frfs(held_, {free}), plain), 1e-4);
}

class MissingSupport : public TurnedSupport {
 protected:
  MissingSupport() {
    root_.nodes = {1, 12, 23, 34, 45};
    root_.variant = "held";
  }

  [[nodiscard]] TestContext free_setting() const {
    return support::plate_context(bundle_, free_);
  }

  structure::Deck free_ = support::plate_deck(false);
  Location root_;
};

TEST_F(MissingSupport, HeldIsThePlateThatHasIt) {
  for (const char* variant : {"held", "held-translations", "held-Z"}) {
    root_.variant = variant;
    structure::Deck clamped = free_;
    for (const int node : root_.nodes) {
      clamped.constraints.push_back({node, updating::held_components(variant)});
    }
    const EffectInstance held{&find("support-mismatch"), root_, {}};
    const Eigen::MatrixXcd expected = frfs(clamped, {});
    EXPECT_GT(updating::difference(frfs(free_, {}), expected), 0.1) << variant;
    // Static answers bring both bases to about 1e-6 of each other.
    EXPECT_LT(updating::difference(frfs(free_, {held}), expected), 1e-4)
        << variant;
  }
}

TEST_F(MissingSupport, IsLookedForAlongEdgesAndAtCorners) {
  const std::vector<Location> places =
      support_mismatch().places(free_setting());
  EXPECT_EQ(std::ranges::count(places, root_), 1);
  root_.variant = "held-translations";
  EXPECT_EQ(std::ranges::count(places, root_), 1);
  // A hinge and a clamp at each of clamp_places(), nothing to be released.
  EXPECT_EQ(places.size(), 22U);
  EXPECT_TRUE(support_mismatch().takes("held-Z", root_, free_setting()));
  EXPECT_TRUE(support_mismatch().released(root_, free_setting()).empty());
}

// What the deck holds in part may be held wholly, as a clamp that is a hinge in
// the deck.
TEST_F(MissingSupport, IsLookedForWhereTheDeckHoldsInPart) {
  free_.constraints.push_back({55, "3"});
  std::vector<Location> places = support_mismatch().places(free_setting());
  EXPECT_GT(places.size(), 1U);
  EXPECT_EQ(std::ranges::count_if(places, updating::is_held), 1);
  Location corner;
  corner.nodes = {55};
  corner.variant = "held";
  EXPECT_EQ(std::ranges::count(places, corner), 1);
  free_.constraints.back().components = "123456";
  places = support_mismatch().places(free_setting());
  EXPECT_FALSE(places.empty());
  EXPECT_TRUE(std::ranges::none_of(places, updating::is_held));
}

// A plate that the deck keeps from all but bending: a hinge along Z.
TEST_F(MissingSupport, HoldsNothingThatIsHeldEverywhere) {
  for (const structure::Grid& grid : free_.grids) {
    free_.constraints.push_back({grid.id, "126"});
  }
  const std::vector<Location> places =
      support_mismatch().places(free_setting());
  EXPECT_EQ(std::ranges::count(places, root_), 1);
  EXPECT_EQ(places.size(), 22U);
  const auto fresh = updating::newly_held(free_, root_);
  ASSERT_EQ(fresh.size(), 5U);
  EXPECT_EQ(fresh[0].components, "345");
}

TEST_F(MissingSupport, CardsHoldItWhenReadBack) {
  const auto cards = support_mismatch().bulk_data(root_, free_setting(), {});
  std::string text;
  for (const int node : root_.nodes)
    text += fmt::format("GRID,{},,0.,0.,0.\n", node);
  for (const std::string& card : cards) text += card + "\n";
  const structure::Deck read = structure::deck_of(text);
  ASSERT_EQ(read.constraints.size(), 5U) << text;
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(read.constraints[k].grid, root_.nodes[k]);
    EXPECT_EQ(read.constraints[k].components, "123456");
  }
}

}  // namespace
}  // namespace tapfit::effects
