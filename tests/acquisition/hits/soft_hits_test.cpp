// Where no band is given, hits are judged up to where the usual one's force has
// fallen by 10 dB. Each shape's spectrum is known in closed form.
#include "acquisition/hits/find_hits.hpp"
#include "tests/acquisition/support/soft_records.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

using testing::Tip;

// Spectrum over that at zero frequency at x = f * width: of a half sine
// cos(pi x) / (1 - 4 x^2), of Hann's window sinc(x) / (1 - x^2).
double level(double power, double x) {
  const double pi = std::numbers::pi;
  if (power == 1.0) return std::cos(pi * x) / (1.0 - 4.0 * x * x);
  return std::sin(pi * x) / (pi * x) / (1.0 - x * x);
}

// The first f * width at -10 dB, between the removable singularity (0.5 and 1,
// where the level is -2 and -6 dB) and the first zero (1.5 and 2).
double closed_form(double power) {
  double above = power == 1.0 ? 0.51 : 1.01;
  double below = power == 1.0 ? 1.5 : 2.0;
  while (below - above > 1e-9) {
    const double middle = 0.5 * (above + below);
    (level(power, middle) > std::pow(10.0, -0.5) ? above : below) = middle;
  }
  return above;
}

TEST(SoftHits, CleanBlowsAreNone) {
  std::mt19937_64 random(1);
  for (const double power : {1.0, 1.5, 2.0}) {
    for (const double rate :
         {256.0, 512.0, 2048.0, 8192.0, 25600.0, 48000.0, 51200.0}) {
      for (const double width :
           {0.2e-3, 0.5e-3, 1e-3, 2e-3, 4e-3, 6e-3, 8e-3, 10e-3}) {
        const HitSet hits = testing::hits_of({rate, width, power}, random);
        ASSERT_EQ(hits.runs[0].size(), 6U) << rate << " " << width;
        for (const Hit& hit : hits.runs[0]) {
          EXPECT_TRUE(hit.accepted) << rate << " Hz, " << width << " s, power "
                                    << power << ": " << name(hit.reasons.at(0));
        }
        if (power == 1.5) continue;
        const double most = 0.4 * rate;
        const double closed = std::min(closed_form(power) / width, most);
        // The sum over samples aliases: where a pulse has three samples, by
        // 1 % of its frequency; the filter cuts at 0.42 of the rate, gently
        // from 0.38 on.
        EXPECT_NEAR(hits.usable_bandwidth_hz,
                    closed,
                    (closed > 0.36 * rate ? 0.1 : 0.02) * closed)
            << rate << " Hz, " << width << " s, power " << power;
      }
    }
  }
}

// With a band a hit is soft where its spectrum is 20 dB down anywhere in it: a
// half sine's from 1.31 / width on, through the zero at 1.5 and the lobes.
TEST(SoftHits, WithABandTheyFallBy20DecibelsInIt) {
  std::mt19937_64 random(3);
  TestBundle bundle = testing::hammer_bundle();
  for (const double width : {2e-3, 8e-3}) {
    const Recording recording = testing::blows_of({4096.0, width, 1.0}, random);
    for (const double x :
         {1.2, 1.28, 1.34, 1.36, 1.44, 1.5, 1.6, 1.75, 2.0, 2.4, 2.5, 3.1}) {
      bundle.band_hz = {5.0, x / width};
      const bool soft =
          testing::judged_soft(find_hits(bundle, {recording}, {})) > 0;
      EXPECT_EQ(soft, std::abs(level(1.0, std::min(x, 1.5))) < 0.1)
          << x << " of 1 / width, " << width << " s";
    }
  }
}

// What is twice as wide as the others is soft, whatever the rate.
TEST(SoftHits, AMuchWiderBlowIsOne) {
  std::mt19937_64 random(2);
  for (const double rate : {2048.0, 25600.0, 51200.0}) {
    for (const double width : {3e-3, 10e-3}) {
      const Tip tip{rate, width, 2.0};
      Recording recording = testing::blows_of(tip, random);
      const auto n = recording.samples.rows();
      Eigen::VectorXd longer = recording.samples.col(0);
      // The last of the six, 25 N, is taken off and struck anew.
      const double gap_s = testing::gap_of(tip);
      const auto from = static_cast<Eigen::Index>(5.3 * gap_s * rate);
      longer.tail(n - from).setZero();
      testing::add_pulse(
          longer, rate, 5.6 * gap_s, 2.0 * width, 25.0, false, 2.0);
      recording.samples.col(0) = longer;
      const HitSet hits = find_hits(testing::hammer_bundle(), {recording}, {});
      EXPECT_EQ(testing::judged_soft(hits), 1) << rate << " " << width;
      EXPECT_FALSE(hits.runs[0].back().accepted);
    }
  }
}

}  // namespace
}  // namespace tapfit::acquisition
