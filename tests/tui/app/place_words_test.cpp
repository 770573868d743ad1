#include "tui/app/place_words.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

// What is offered for a mistake of the sheet means what it was made from.
TEST(PlaceWords, OfASheetAreReadAsTheGridThere) {
  const structure::Deck deck = support::plate_deck(true);
  const acquisition::TestBundle bundle = support::plate_bundle();
  const effects::Setting setting = support::plate_setting(bundle, deck);
  const auto words =
      place_words(effects::find("point-mislabelled"), setting, "hammer:28");
  EXPECT_EQ(words, std::vector<std::string>{"hammer:28:"});
  const updating::Where where =
      updating::parse_effect("point-mislabelled@hammer:28:").where;
  EXPECT_EQ(where.nodes, std::vector{28});
  EXPECT_EQ(where.node, 0);
  EXPECT_EQ(place_words(effects::find("point-mislabelled"), setting, "acc1"),
            std::vector<std::string>{"acc1:11:"});
}

}  // namespace
}  // namespace tapfit::tui
