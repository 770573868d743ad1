#include "signal/spectra/noise_spectrum.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tapfit::signal {
namespace {

std::vector<Eigen::VectorXd> quiet(Eigen::Index samples, int stretches) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(3.0, 0.5);
  std::vector<Eigen::VectorXd> result;
  for (int k = 0; k < stretches; ++k) {
    result.emplace_back(
        Eigen::VectorXd::NullaryExpr(samples, [&] { return normal(random); }));
  }
  return result;
}

// A hit at the very beginning of a record leaves a handful of samples.
TEST(NoiseSpectrum, FewSamplesTellWhiteNoise) {
  const NoiseSpectrum noise = noise_spectrum(quiet(8, 300), 0.01);
  // 2100 degrees of freedom: 3 % standard deviation.
  EXPECT_NEAR(noise.at(0.0), 0.25, 0.025);
  EXPECT_EQ(noise.at(100.0), noise.at(0.0));
}

TEST(NoiseSpectrum, NothingIsKnownFromNothing) {
  EXPECT_EQ(noise_spectrum({}, 0.01).S.size(), 0);
  EXPECT_EQ(noise_spectrum(quiet(3, 5), 0.01).S.size(), 0);
}

}  // namespace
}  // namespace tapfit::signal
