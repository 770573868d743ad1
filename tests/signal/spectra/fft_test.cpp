#include "signal/spectra/fft.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

namespace tapfit::signal {
namespace {

Eigen::VectorXd random_samples(Eigen::Index n, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x(i) = normal(engine);
  return x;
}

// The definition, in long double.
Eigen::VectorXcd definition(const Eigen::VectorXd& x, Eigen::Index n) {
  Eigen::VectorXcd X(n / 2 + 1);
  for (Eigen::Index k = 0; k < X.size(); ++k) {
    long double re = 0.0L;
    long double im = 0.0L;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const long double angle = -2.0L * std::numbers::pi_v<long double> *
                                static_cast<long double>((k * i) % n) /
                                static_cast<long double>(n);
      re += static_cast<long double>(x(i)) * std::cos(angle);
      im += static_cast<long double>(x(i)) * std::sin(angle);
    }
    X(k) = {static_cast<double>(re), static_cast<double>(im)};
  }
  return X;
}

TEST(Fft, IsTheDefinition) {
  // A product of small primes, odd, prime, and the smallest ones.
  for (const Eigen::Index n : {1, 2, 3, 64, 105, 251, 360}) {
    const Eigen::VectorXd x = random_samples(n, 7);
    RealFft fft(n);
    // Rounding grows as log n; 1e-14 times the norm leaves a factor of ten.
    EXPECT_LT((fft.transform(x) - definition(x, n)).cwiseAbs().maxCoeff(),
              1e-14 * x.norm() * std::sqrt(static_cast<double>(n)))
        << n;
  }
}

TEST(Fft, FillsUpWithZeros) {
  RealFft fft(48);
  const Eigen::VectorXd x = random_samples(20, 3);
  (void)fft.transform(random_samples(48, 4));  // leaves something in the buffer
  EXPECT_LT((fft.transform(x) - definition(x, 48)).cwiseAbs().maxCoeff(),
            1e-13);
}

// More lengths than plans are kept, so that some are planned anew, and a
// transform that outlives its plan's stay there.
TEST(Fft, IsTheDefinitionWhoeverPlanned) {
  RealFft early(40);
  for (int round = 0; round < 2; ++round) {
    for (Eigen::Index n = 20; n < 40; ++n) {
      const Eigen::VectorXd x = random_samples(n, 5);
      RealFft first(n);
      RealFft second(n);
      EXPECT_LT((first.transform(x) - definition(x, n)).norm(), 1e-12) << n;
      EXPECT_EQ(first.transform(x), second.transform(x));
    }
  }
  const Eigen::VectorXd x = random_samples(40, 6);
  EXPECT_LT((early.transform(x) - definition(x, 40)).norm(), 1e-12);
}

TEST(Fft, PlansFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> error(4, 1.0);
  for (std::size_t t = 0; t < error.size(); ++t)
    threads.emplace_back([&error, t] {
      error[t] = 0.0;
      for (Eigen::Index n = 50; n < 90; ++n) {
        const Eigen::VectorXd x = random_samples(n, 5);
        RealFft fft(n);
        error[t] = std::max(error[t], std::abs(fft.transform(x)(0) - x.sum()));
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const double e : error) EXPECT_LT(e, 1e-12);
}

}  // namespace
}  // namespace tapfit::signal
