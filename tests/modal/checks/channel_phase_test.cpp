#include "modal/checks/channel_phase.hpp"

#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <functional>
#include <gmock/gmock.h>
#include <random>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Law = std::function<std::complex<double>(std::complex<double>)>;

/// FRFs of two sensors on a plate with six modes in the band, the second
/// through what its channel does.
class ChannelPhaseTest : public ::testing::Test {
 protected:
  ChannelPhaseTest()
      : system_(test::random_system(6, 4, 0.005, 0.015, random_)) {
    bundle_.channels.resize(3);
    bundle_.channels[0].name = "hammer";
    bundle_.channels[1].name = "acc1";
    bundle_.channels[2].name = "acc2";
    bundle_.runs.resize(4);
    for (Index k = 0; k < 6; ++k) {
      Mode mode;
      const double w = 2.0 * std::numbers::pi * system_.frequency_hz(k);
      const double zeta = system_.damping_ratio(k);
      mode.pole = {-zeta * w, w * std::sqrt(1.0 - zeta * zeta)};
      modes_.modes.push_back(mode);
    }
  }

  [[nodiscard]] signal::FrfSet through(const Law& law) {
    signal::FrfSet set =
        test::roving_hammer(system_,
                            {0, 1},
                            test::line_points(5.0, 100.0, 1901, 0.2),
                            0.001,
                            random_);
    for (signal::Frf& frf : set.frfs) {
      frf.channel = frf.response.node == 1 ? 1 : 2;
      if (frf.channel == 1) continue;
      for (Index l = 0; l < set.lines(); ++l) frf.H(l) *= law(set.s(l));
    }
    return set;
  }

  std::mt19937_64 random_{5};
  test::SyntheticSystem system_;
  acquisition::TestBundle bundle_;
  ModeSet modes_;
};

// H = s / (s + w_c) and w_c / (s + w_c).
TEST_F(ChannelPhaseTest, FiltersOfFirstOrderAreToldWithTheirCorners) {
  for (const bool high : {true, false}) {
    const double corner_hz = high ? 4.0 : 60.0;
    const double corner = 2.0 * std::numbers::pi * corner_hz;
    const signal::FrfSet set = through([&](std::complex<double> s) {
      return (high ? s : std::complex<double>(corner)) / (s + corner);
    });
    const auto phases = channel_phases(set, modes_);
    ASSERT_EQ(phases.size(), 2U);
    ASSERT_TRUE(phases[1].filter);
    EXPECT_EQ(phases[1].filter->high_pass, high);
    EXPECT_NEAR(phases[1].filter->corner_hz, corner_hz, 0.05 * corner_hz);
    const auto findings = channel_phase_findings(bundle_, set, modes_);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].where.channel, "acc2");
    EXPECT_EQ(findings[0].severity, Severity::Warning);
    EXPECT_THAT(findings[0].what,
                testing::HasSubstr(high ? "high-pass" : "low-pass"));
  }
}

// A pure delay is no filter, and a good channel has neither.
TEST_F(ChannelPhaseTest, DelayIsNoFilterAndNothingIsFoundInGoodChannels) {
  static constexpr double delay_s = 1e-3;
  const auto late = channel_phase_findings(
      bundle_,
      through([](std::complex<double> s) { return std::exp(-s * delay_s); }),
      modes_);
  ASSERT_EQ(late.size(), 1U);
  EXPECT_THAT(late[0].what, testing::HasSubstr("1 ms"));
  EXPECT_THAT(late[0].what, testing::HasSubstr("behind the hammer"));
  const auto none = channel_phase_findings(
      bundle_,
      through([](std::complex<double>) { return std::complex<double>(1.0); }),
      modes_);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tapfit::modal
