#include "acquisition/foundation/nearest_word.hpp"

#include <gtest/gtest.h>

namespace tapfit {
namespace {

// One letter put in, left out, changed, or exchanged with its neighbour is one;
// "kitten" to "sitting" is the textbooks' three.
TEST(Misspellings, CountsLetters) {
  EXPECT_EQ(misspellings("", ""), 0U);
  EXPECT_EQ(misspellings("", "abc"), 3U);
  EXPECT_EQ(misspellings("joint", "joint"), 0U);
  EXPECT_EQ(misspellings("joimt", "joint"), 1U);
  EXPECT_EQ(misspellings("jint", "joint"), 1U);
  EXPECT_EQ(misspellings("joiint", "joint"), 1U);
  EXPECT_EQ(misspellings("jonit", "joint"), 1U);
  EXPECT_EQ(misspellings("kitten", "sitting"), 3U);
}

TEST(NearestWord, IsTheOneThatWasMeant) {
  const std::vector<std::string> known{
      "hits", "frf", "modes", "model", "diagnose", "sensor-mass"};
  EXPECT_EQ(nearest_word("diagnos", known), "diagnose");
  EXPECT_EQ(nearest_word("diagnsoe", known), "diagnose");
  EXPECT_EQ(nearest_word("mods", known), "modes");
  EXPECT_EQ(nearest_word("sensor", known), "sensor-mass");
  EXPECT_EQ(nearest_word("recordings/plate", known), std::nullopt);
  EXPECT_EQ(nearest_word("x", known), std::nullopt);
  EXPECT_EQ(nearest_word("", known), std::nullopt);
  EXPECT_EQ(did_you_mean("htis", known), "did you mean hits? ");
  EXPECT_EQ(did_you_mean("qqqq", known), "");
}

}  // namespace
}  // namespace tapfit
