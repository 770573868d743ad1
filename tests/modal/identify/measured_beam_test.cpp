#include "tests/modal/support/measured_beam.hpp"

#include "modal/identify/identify_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace tapfit {
namespace {

using test::beam_data;

TEST(MeasuredBeam, HasOneBendingModeInEachBandAndHardlyAnyDamping) {
  if (!std::filesystem::exists(beam_data))
    GTEST_SKIP() << beam_data << " is not there";
  struct Noted {
    double low, high, hz;  // its makers' bands; what its note gives
  };
  const signal::FrfSet frfs = test::read_beam({1, 2, 3, 4, 5, 6, 7, 8, 9});
  for (const Noted& noted : {Noted{108.0, 116.0, 111.99},
                             Noted{300.0, 312.0, 306.86},
                             Noted{590.0, 600.0, 596.37},
                             Noted{970.0, 980.0, 974.14}}) {
    modal::IdentifyOptions options;
    options.band_hz = {noted.low, noted.high};
    const modal::ModeSet found = modal::identify_modes(frfs, options);
    ASSERT_EQ(found.modes.size(), 1U) << noted.hz;
    const modal::Mode& mode = found.modes[0];
    // Half the spacing of the lines at the lowest, and the note's last digit.
    EXPECT_NEAR(mode.frequency_hz, noted.hz, 1e-4 * noted.hz);
    // As the note says. Of the lowest mode two lines span the bandwidth.
    EXPECT_LT(mode.damping_ratio, 2e-4) << noted.hz;
    const bool told =
        std::ranges::any_of(found.warnings, [](const std::string& warning) {
          return warning.find("hardly resolved") != std::string::npos;
        });
    EXPECT_EQ(told, noted.hz < 200.0);
    EXPECT_GT(mode.mpc, 0.95);
    EXPECT_TRUE(found.scaled);
    RecordProperty(
        fmt::format("mode_{:.0f}", noted.hz),
        fmt::format("{:.3f} Hz sd {:.1g}, damping {:.2g} sd {:.1g}, error "
                    "{:.3f} from {:.3f}",
                    mode.frequency_hz,
                    mode.frequency_sd_hz,
                    mode.damping_ratio,
                    mode.damping_sd,
                    found.synthesis_error,
                    found.unrefined_error));
  }
}

// Its nine FRFs were hit one after the other and differ by some 1e-5 in pole:
// two poles follow that, and are one mode for all that. In a wide band and in a
// narrow one it is the same.
TEST(MeasuredBeam, HasItsModesOnceInBandsOfAnyWidth) {
  if (!std::filesystem::exists(beam_data))
    GTEST_SKIP() << beam_data << " is not there";
  const signal::FrfSet frfs = test::read_beam({1, 2, 3, 4, 5, 6, 7, 8, 9});
  for (const std::array<double, 2>& band : {std::array{580.0, 620.0},
                                            std::array{590.0, 600.0},
                                            std::array{400.0, 700.0}}) {
    modal::IdentifyOptions options;
    options.band_hz = band;
    const modal::ModeSet found = modal::identify_modes(frfs, options);
    ASSERT_EQ(found.modes.size(), 1U) << band[0];
    EXPECT_NEAR(found.modes[0].frequency_hz, 596.37, 0.01);
    // From band to band by three standard deviations of 1 to 2 %.
    EXPECT_NEAR(found.modes[0].damping_ratio, 1.007e-4, 0.05e-4) << band[0];
    EXPECT_LE(found.synthesis_error, found.unrefined_error) << band[0];
  }
}

}  // namespace
}  // namespace tapfit
