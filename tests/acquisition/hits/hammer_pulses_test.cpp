// What is measured of a hammer channel that drifts.
#include "acquisition/hits/hammer_pulses.hpp"

#include "tests/acquisition/support/hammer_record.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

// At 256 Hz a piece is a second long, in which a drift of 50 N/s makes its
// bounds too wide by as much. The trigger is set in percent of the peak.
TEST(PrepareHammer, KnowsItsPeakHoweverTheChannelDrifts) {
  constexpr double rate = 256.0;
  for (const double sign : {1.0, -1.0}) {
    for (const double slope : {0.0, 10.0, -50.0, 50.0}) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(8 * 256);
      for (const double time_s : {1.6, 3.3, 6.1}) {
        testing::add_pulse(force, rate, time_s, 0.03, 80.0, false);
      }
      force = sign * force +
              Eigen::VectorXd::LinSpaced(force.size(), 0.0, 8.0 * slope);
      const HammerSignal hammer = prepare_hammer(force, rate);
      EXPECT_EQ(hammer.polarity, sign) << slope;
      const Eigen::VectorXd values =
          hammer.force.segment(0, hammer.force.size());
      EXPECT_NEAR(hammer.peak, values.maxCoeff(), 1e-9) << slope;
      // Less what the median sees of the pulse itself, on a steep ramp.
      EXPECT_NEAR(hammer.peak, 80.0, 3.0) << slope;
    }
  }
}

}  // namespace
}  // namespace tapfit::acquisition
