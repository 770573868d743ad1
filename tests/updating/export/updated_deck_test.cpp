#include "updating/export/updated_deck.hpp"

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tapfit::updating {
namespace {

// A second absorber needs a grid and elements of its own.
TEST(UpdatedDeck, AbsorbersShareNoIds) {
  structure::Deck deck;
  for (const int id : {1, 2}) {
    structure::Grid grid;
    grid.id = id;
    deck.grids.push_back(grid);
  }
  acquisition::TestBundle bundle;
  acquisition::Run run;
  run.sensors = {{0, {2, 3, 1}}};
  bundle.runs = {run};
  std::vector<Candidate> added(2);
  for (int k = 0; k < 2; ++k) {
    added[static_cast<std::size_t>(k)].effect = "absorber";
    added[static_cast<std::size_t>(k)].where.node = k + 1;
  }
  std::set<std::string> grids;
  std::set<std::string> elements;
  std::size_t cards = 0;
  for (const std::string& card : effect_cards(added, bundle, deck)) {
    if (card.starts_with("$")) continue;
    const std::size_t comma = card.find(',');
    const std::string id =
        card.substr(comma + 1, card.find(',', comma + 1) - comma - 1);
    (card.starts_with("GRID") ? grids : elements).insert(id);
    ++cards;
  }
  EXPECT_EQ(cards, 8U);
  EXPECT_EQ(grids.size(), 2U);
  EXPECT_EQ(elements.size(), 6U);
}

// Half way between grids 1 and 2 a mass sits on a grid of its own, which
// follows grid 1 by a rigid arm.
TEST(UpdatedDeck, WhatSitsBetweenGridsStandsOnAnArm) {
  structure::Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {0.2, 0, 0}}};
  acquisition::TestBundle bundle;
  acquisition::Run run;
  run.sensors = {{0, {2, 3, 1}}};
  bundle.runs = {run};
  Candidate mass;
  mass.effect = "added-mass";
  mass.where.node = 1;
  mass.where.at = {0.1, 0.0, 0.0};
  mass.parameters = {{"mass_kg", 0.02, 0.001, 0.018, 0.022}};
  const std::vector<std::string> cards = effect_cards({mass}, bundle, deck);
  ASSERT_EQ(cards.size(), 4U);
  EXPECT_TRUE(cards[1].starts_with("GRID,3,0,0.1")) << cards[1];
  EXPECT_EQ(cards[2], "RBE2,1,1,123456,3");
  EXPECT_TRUE(cards[3].starts_with("CONM2,2,3,")) << cards[3];
}

TEST(UpdatedDeck, AddedElementsTakeNoIdOfASolid) {
  structure::Deck deck;
  deck.solids.emplace_back().id = 7;
  EXPECT_EQ(structure::free_element(deck, 0), 8);
}

}  // namespace
}  // namespace tapfit::updating
