#include "tui/app/place_words.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

using Words = std::vector<std::string>;

// A sensor at grid 11, blows at 28 and 30.
acquisition::TestBundle roving_hammer() {
  acquisition::TestBundle bundle;
  for (const char* name : {"hammer", "acc1"}) {
    bundle.channels.emplace_back();
    bundle.channels.back().name = name;
  }
  for (const int node : {28, 30}) {
    acquisition::Run run;
    run.hammer = {0, {node, 3, 1}};
    run.sensors = {{1, {11, 3, 1}}};
    bundle.runs.push_back(run);
  }
  return bundle;
}

// What is offered for a mistake of the sheet means what it was made from.
TEST(PlaceWords, OfASheetAreReadAsTheGridThere) {
  const acquisition::TestBundle bundle = roving_hammer();
  effects::TestContext context;
  context.bundle = &bundle;
  const effects::Effect& mislabelled = effects::find("point-mislabelled");
  EXPECT_EQ(place_words(mislabelled, context, "hammer"),
            (Words{"hammer:28:", "hammer:30:"}));
  EXPECT_EQ(place_words(mislabelled, context, "acc1"), Words{"acc1:11:"});
  const updating::Location where =
      updating::parse_effect("point-mislabelled@hammer:28:").where;
  EXPECT_EQ(where.nodes, std::vector{28});
  EXPECT_EQ(where.node, 0);
}

}  // namespace
}  // namespace tapfit::tui
