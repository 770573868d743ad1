// What follows behind a block's end, against sums of the samples themselves and
// against the exact FRF.
#include "signal/spectra/block_tail.hpp"

#include "tests/signal/support/scale_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::signal {
namespace {

using complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

constexpr double dt = 1.0 / 512.0;

Eigen::VectorXcd two_poles() {
  Eigen::VectorXcd poles(2);
  poles << complex(-0.5, 2.0 * pi * 7.3), complex(-2.0, 2.0 * pi * 31.0);
  return poles;
}

// Free decays from row 0 on, over an offset.
Eigen::VectorXd decaying(const Eigen::VectorXcd& amplitudes,
                         double offset,
                         Index n) {
  const Eigen::VectorXcd poles = two_poles();
  Eigen::VectorXd x(n);
  for (Index i = 0; i < n; ++i) {
    const Eigen::ArrayXcd decay =
        (poles.array() * (dt * static_cast<double>(i))).exp();
    x(i) = offset + (amplitudes.array() * decay).sum().real();
  }
  return x;
}

TEST(BlockTail, IsTheSumOfWhatFollows) {
  constexpr Index block = 1024;
  constexpr Index trigger = 64;
  const double T = static_cast<double>(block - trigger) * dt;
  Eigen::VectorXcd a(2);
  a << complex(3.0, -1.0), complex(-0.4, 2.0);
  const BlockTail tail =
      fit_tail(decaying(a, 0.3, block), trigger, dt, two_poles());
  ASSERT_EQ(tail.poles.size(), 2);
  Eigen::VectorXcd s(4);
  s << complex(0.0, 2.0 * pi * 7.0), complex(0.0, 2.0 * pi * 100.0),
      complex(4.0, 2.0 * pi * 31.0), complex(0.7, 0.0);
  const Eigen::VectorXcd kernel = (-s * T).array().exp();
  const Eigen::VectorXcd sum = tail_spectra(tail, s, kernel, dt);
  // Forty seconds: exp(-0.5 x 40) = 2e-9 of the slowest is left.
  const Eigen::VectorXd all = decaying(a, 0.0, 20480);
  for (Index i = 0; i < s.size(); ++i) {
    complex expected = 0.0;
    for (Index n = block; n < all.size(); ++n) {
      const double t = static_cast<double>(n - trigger) * dt;
      expected += all(n) * std::exp(-s(i) * t);
    }
    EXPECT_LT(std::abs(sum(i) - expected), 1e-6 * std::abs(expected)) << i;
  }
}

TEST(BlockTail, IsNoneWhereHalfTheBlockHoldsNoTwoPeriods) {
  Eigen::VectorXcd a(2);
  a << 1.0, 1.0;
  // Two periods of 7.3 Hz are 141 samples.
  EXPECT_EQ(fit_tail(decaying(a, 0.0, 340), 64, dt, two_poles()).poles.size(),
            0);
  EXPECT_EQ(fit_tail(decaying(a, 0.0, 350), 64, dt, two_poles()).poles.size(),
            2);
  EXPECT_EQ(fit_tail(decaying(a, 0.0, 350), 64, dt, {}).poles.size(), 0);
}

complex pole_of(const TestMode& mode) {
  const double w = 2.0 * pi * mode.hz;
  return {-mode.zeta * w, w * std::sqrt(1.0 - mode.zeta * mode.zeta)};
}

// Where the exact FRF is known: one time constant in the block, which without
// the tail is off by more than a third.
TEST(BlockTail, MakesFrfsOfCutBlocksRight) {
  GeneratedOptions o;
  o.block = 2048;
  const double T = static_cast<double>(o.block - o.pre_trigger) / o.fs;
  std::vector<TestMode> modes{{20.0, 0.0, 1.0}, {61.0, 0.0, 0.7}};
  for (TestMode& mode : modes) mode.zeta = 1.0 / (2.0 * pi * mode.hz * T);
  GeneratedTest test = generate_test(modes, o);
  for (const double end : {1.0, 0.3}) {
    FrfOptions options;
    options.window.end_value = end;
    EXPECT_GT(worst_of(test, modes, options).scale, 0.1);
    options.lasting_poles.resize(2);
    options.lasting_poles << pole_of(modes[0]), pole_of(modes[1]);
    // Substeps of the generated pulse leave 2e-5 of it.
    EXPECT_LT(worst_of(test, modes, options).scale, 2e-4);
    Eigen::VectorXcd s(3);
    s << complex(0.0, 2.0 * pi * 20.0), complex(0.2, 2.0 * pi * 33.3),
        complex(1.0, 2.0 * pi * 61.0);
    const FrfSet set = estimate_frfs_at(
        test.bundle, test.recordings, test.hits, s, options.lasting_poles);
    for (Index i = 0; i < s.size(); ++i) {
      const complex exact = exact_frf(modes, s(i));
      EXPECT_LT(std::abs(set.frfs[0].H(i) - exact), 2e-4 * std::abs(exact));
    }
  }
}

// Behind a block that the next blow cuts into nothing decays freely.
TEST(BlockTail, IsNoneWhereTheNextBlowComesFirst) {
  GeneratedOptions o;
  o.block = 2048;
  o.hits = 2;
  const std::vector<TestMode> modes{{20.0, 0.001, 1.0}};
  GeneratedTest test = generate_test(modes, o);
  test.hits.runs[0][1].accepted = false;
  FrfOptions options;
  const auto estimated = [&] {
    return estimate_frfs(test.bundle, test.recordings, test.hits, options)
        .frfs[0]
        .H;
  };
  const auto tail = [&] {
    options.lasting_poles.resize(0);
    const Eigen::VectorXcd cut = estimated();
    options.lasting_poles.setConstant(1, pole_of(modes[0]));
    return (estimated() - cut).norm() / cut.norm();
  };
  EXPECT_GT(tail(), 1e-3);
  // The next one now comes 64 samples before the block's end.
  test.hits.runs[0][1].trigger =
      test.hits.runs[0][0].trigger + o.block - o.pre_trigger - 64;
  EXPECT_EQ(tail(), 0.0);
}

}  // namespace
}  // namespace tapfit::signal
