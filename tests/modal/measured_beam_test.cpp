// Measured FRFs of a suspended beam, made by others: a roving hammer past one
// accelerometer. Their folder lies beside the project and is not part of it.
#include "modal/identify_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

namespace tapfit {
namespace {

namespace fs = std::filesystem;

const fs::path data = TAPFIT_SOURCE_DIR "/../shared/data/suspended-beam-frf";

/// Lines of frequency, real and imaginary part; anything else is heading.
signal::Frf read_frf(const fs::path& file,
                     double low_hz,
                     double high_hz,
                     std::vector<double>& hz) {
  std::ifstream in(file);
  std::vector<std::complex<double>> values;
  hz.clear();
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    double f = 0.0;
    double re = 0.0;
    double im = 0.0;
    if (!(numbers >> f >> re >> im) || f < low_hz || f > high_hz) continue;
    hz.push_back(f);
    values.emplace_back(re, im);
  }
  signal::Frf frf;
  frf.H = Eigen::Map<Eigen::VectorXcd>(
      values.data(), static_cast<Eigen::Index>(values.size()));
  return frf;
}

signal::FrfSet read_beam() {
  signal::FrfSet set;
  std::vector<double> hz;
  for (int point = 1; point <= 9; ++point) {
    signal::Frf frf = read_frf(data / fmt::format("ASCII{:05d}", point) /
                                   fmt::format("Hxysv{:05d}.txt", point),
                               65.0,
                               1010.0,
                               hz);
    frf.reference = {point, 1, 1};
    frf.response = {4, 1, -1};  // at z = 0.5 m, where the fourth hit point is
    frf.run = static_cast<std::size_t>(point - 1);
    set.frfs.push_back(std::move(frf));
  }
  set.s.resize(static_cast<Eigen::Index>(hz.size()));
  for (std::size_t k = 0; k < hz.size(); ++k) {
    set.s(static_cast<Eigen::Index>(k)) = {0.0, 2.0 * std::numbers::pi * hz[k]};
  }
  return set;
}

TEST(MeasuredBeam, HasOneBendingModeInEachBandAndHardlyAnyDamping) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  struct Noted {
    double low, high, hz;  // its makers' bands; what its note gives
  };
  const signal::FrfSet frfs = read_beam();
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

}  // namespace
}  // namespace tapfit
