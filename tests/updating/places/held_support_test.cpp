#include "updating/places/held_support.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tapfit::updating {
namespace {

Location held_along(const std::vector<int>& nodes, const std::string& variant) {
  Location where;
  where.nodes = nodes;
  where.variant = variant;
  return where;
}

TEST(HeldSupport, HoldsWhatItsVariantSays) {
  const structure::Deck deck = support::plate_deck(true);
  EXPECT_EQ(held_components("held"), "123456");
  EXPECT_EQ(held_components("free"), "");
  EXPECT_TRUE(is_held(held_along({11}, "held-Z")));
  EXPECT_FALSE(is_held(held_along({11}, "free-Z")));
  // Grid 1 is clamped, grid 11 is not.
  const auto fresh = newly_held(deck, held_along({1, 11}, "held-translations"));
  ASSERT_EQ(fresh.size(), 1U);
  EXPECT_EQ(fresh[0].node, 11);
  EXPECT_EQ(fresh[0].components, "123");
}

// As the same deck with a constraint there, once its elements are split.
TEST(HeldSupport, OnASplitMeshHoldsWhatConstraintsWould) {
  const std::vector<int> along = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  for (const char* variant : {"held", "held-translations"}) {
    const structure::Deck deck = support::plate_deck(true);
    structure::Deck held = deck;
    for (const int node : along) {
      held.constraints.push_back({node, held_components(variant)});
    }
    const auto fixed = [](const structure::Deck& of) {
      std::set<int> dofs;
      for (const structure::Constraint& c : of.constraints) {
        for (const char digit : c.components) {
          dofs.insert(6 * static_cast<int>(of.grid_index(c.grid)) + digit -
                      '1');
        }
      }
      return dofs;
    };
    const structure::RefinedDeck mesh = structure::refine_mesh(deck);
    std::set<int> all = fixed(mesh.deck);
    // From grid 1, which the deck clamps, to the tip.
    EXPECT_GT(held_dofs(mesh, held_along(along, variant)).size(), 50U);
    for (const int dof : held_dofs(mesh, held_along(along, variant)))
      all.insert(dof);
    EXPECT_EQ(all, fixed(structure::refine_mesh(held).deck)) << variant;
  }
}

}  // namespace
}  // namespace tapfit::updating
