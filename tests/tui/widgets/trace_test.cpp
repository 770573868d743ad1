#include "tui/widgets/trace.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

acquisition::Recording spike_at(Eigen::Index sample, Eigen::Index length) {
  acquisition::Recording recording;
  recording.sample_rate_hz = 100.0;
  recording.samples = Eigen::MatrixXd::Zero(length, 1);
  recording.samples(sample, 0) = -7.0;
  return recording;
}

TEST(Trace, LosesNoExtremeWhenThinned) {
  const Trace t = trace(spike_at(12345, 100000), 1000);
  EXPECT_LE(t.low.rows(), 1000);
  EXPECT_FLOAT_EQ(t.low.minCoeff(), -7.0F);
  const Envelope e = envelope(t, 0, 0.0, t.duration_s(), 50);
  EXPECT_EQ(e.time_s.size(), 50);
  EXPECT_DOUBLE_EQ(e.low.minCoeff(), -7.0);
}

TEST(Trace, KeepsEverySampleOfShortRecordings) {
  const Trace t = trace(spike_at(3, 10));
  EXPECT_EQ(t.stretch, 1);
  EXPECT_EQ(t.low.rows(), 10);
  EXPECT_FLOAT_EQ(t.low(3, 0), -7.0F);
}

TEST(Trace, TakesEmptyRecordings) {
  acquisition::Recording recording;
  const Trace t = trace(recording);
  EXPECT_EQ(t.duration_s(), 0.0);
  EXPECT_EQ(envelope(t, 0, 0.0, 1.0, 10).time_s.size(), 0);
}

}  // namespace
}  // namespace tapfit::tui
