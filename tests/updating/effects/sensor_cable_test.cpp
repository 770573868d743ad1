#include "tests/updating/support/sample_plate.hpp"
#include "updating/effects/effects.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tapfit::effects {
namespace {

// Cards act along basic axes; what a point calls Z may be mostly X, as in a
// cylindrical system.
TEST(SensorCable, CardsOfASkewOneAreAlongTheClosestAxis) {
  structure::Deck deck = support::plate_deck(true);
  structure::MeasuringPoint point;
  point.grid = -5;
  point.axes << 0.0, 0.6, 0.8, 1.0, 0.0, 0.0, 0.0, 0.8, -0.6;
  point.nearest = 30;
  deck.measuring = {point};
  acquisition::TestBundle bundle = support::plate_bundle();
  bundle.runs.front().sensors = {{1, {-5, 3, 1}}};
  const Location where{.channels = {"acc1"}};
  std::string text;
  for (const std::string& card : sensor_cable().bulk_data(
           where, support::plate_context(bundle, deck), {100.0, 1.0})) {
    text += card + "\n";
  }
  EXPECT_NE(text.find("100.0000,30,1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("1.000000,30,1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("$ P5Z+ is along 0.8, 0, -0.6"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace tapfit::effects
