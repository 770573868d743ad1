#include "acquisition/foundation/dof.hpp"

#include <gtest/gtest.h>

namespace tapfit {
namespace {

TEST(Dof, NamesTheFieldsWay) {
  EXPECT_EQ(name(Dof{12, 3, 1}), "12Z+");
  EXPECT_EQ(name(Dof{7, 1, -1}), "7X-");
  EXPECT_EQ(name(Dof{3, 6, 1}), "3RZ+");
}

TEST(Dof, ReadsDirectionsInEverySpelling) {
  const Dof up{5, 3, 1};
  for (const char* text : {"+Z", "Z", "Z+", "z", " +z "}) {
    EXPECT_EQ(parse_direction(5, text), up) << text;
  }
  EXPECT_EQ(parse_direction(5, "-X"), (Dof{5, 1, -1}));
  EXPECT_EQ(parse_direction(5, "RY-"), (Dof{5, 5, -1}));
}

TEST(Dof, RefusesWhatIsNoDirection) {
  for (const char* text : {"", "+", "W", "+Z+", "ZZ", "+-Z", "RR", "Z1"}) {
    EXPECT_EQ(parse_direction(5, text), std::nullopt) << text;
  }
}

TEST(Dof, ReadsPoints) {
  EXPECT_EQ(parse_dof("12Z+"), (Dof{12, 3, 1}));
  EXPECT_EQ(parse_dof("12:+Z"), (Dof{12, 3, 1}));
  EXPECT_EQ(parse_dof("12:Y"), (Dof{12, 2, 1}));
  for (const char* text :
       {"", "Z", "0Z", "-3Z", "12", "12::Z", "99999999999Z"}) {
    EXPECT_EQ(parse_dof(text), std::nullopt) << text;
  }
}

TEST(Dof, NameAndParseAreInverse) {
  for (int component = 1; component <= 6; ++component) {
    for (const int sign : {-1, 1}) {
      const Dof dof{41, component, sign};
      EXPECT_EQ(parse_dof(name(dof)), dof) << name(dof);
    }
  }
}

}  // namespace
}  // namespace tapfit
