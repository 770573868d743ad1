#include "signal/frf_set/kept_lines.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <cstddef>

namespace tapfit::signal {
namespace {

// Two FRFs of a stiff structure: what is measured grows with the square of the
// frequency, the noise is the same everywhere. Noise over signal is q at the
// second of ten lines, 10 Hz apart.
FrfSet stiff_structure(double q) {
  FrfSet set;
  set.s.resize(10);
  set.frfs.resize(2);
  for (Eigen::Index l = 0; l < 10; ++l) {
    set.s(l) = {1.0, 20.0 * M_PI * static_cast<double>(l + 1)};
  }
  for (Frf& frf : set.frfs) {
    frf.H = -set.s.cwiseAbs2().cast<std::complex<double>>();
    frf.coherence = Eigen::VectorXd::LinSpaced(10, 0.1, 1.0);
    const double noise = q * std::norm(set.s(1));
    frf.variance = Eigen::VectorXd::Constant(10, noise * noise);
    frf.change_with_level = frf.H;
  }
  return set;
}

TEST(KeptLines, ThoseOfNoiseAreLeftOut) {
  FrfSet set = stiff_structure(0.13);  // 0.52, 0.13, 0.06, ...
  EXPECT_EQ(leave_out_noisy_lines(set),
            "2 of 10 lines (10 to 20 Hz) are left out of fits: the noise there "
            "is more than a tenth of what is measured");
  ASSERT_EQ(set.lines(), 8);
  EXPECT_NEAR(set.frequency_hz()(0), 30.0, 1e-12);
  for (const Frf& frf : set.frfs) {
    EXPECT_EQ(frf.H.size(), 8);
    EXPECT_EQ(frf.variance.size(), 8);
    EXPECT_DOUBLE_EQ(frf.coherence(0), 0.3);
    EXPECT_EQ(frf.change_with_level(7), frf.H(7));
  }
}

TEST(KeptLines, BelowATenthAllStay) {
  FrfSet set = stiff_structure(0.024);  // 0.097 on the first
  EXPECT_EQ(leave_out_noisy_lines(set), "");
  EXPECT_EQ(set.lines(), 10);
}

TEST(KeptLines, NoiseThatIsTheSameEverywhereLeavesAll) {
  FrfSet set = stiff_structure(0.0);
  for (Frf& frf : set.frfs) frf.variance = 0.04 * frf.H.cwiseAbs2();
  EXPECT_EQ(leave_out_noisy_lines(set), "");
  // q^2 + 0.01 is 0.05: one of more than twice as much stands out.
  for (Frf& frf : set.frfs) frf.variance(4) *= 2.2;
  EXPECT_EQ(leave_out_noisy_lines(set), "");
  for (Frf& frf : set.frfs) frf.variance(4) *= 2.3 / 2.2;
  EXPECT_EQ(leave_out_noisy_lines(set).substr(0, 34),
            "1 of 10 lines (50 Hz) is left out ");
}

TEST(KeptLines, WhereMostAreNoisyAllStay) {
  FrfSet set = stiff_structure(0.0);
  for (Frf& frf : set.frfs) {
    frf.variance.tail(5) = 0.1 * frf.H.tail(5).cwiseAbs2();
  }
  FrfSet more = set;
  EXPECT_EQ(leave_out_noisy_lines(set).substr(0, 16), "5 of 10 lines (6");
  for (Frf& frf : more.frfs) frf.variance(4) = 0.1 * std::norm(frf.H(4));
  EXPECT_EQ(leave_out_noisy_lines(more), "");
  EXPECT_EQ(more.lines(), 10);
}

TEST(KeptLines, OneHitTellsNothing) {
  FrfSet set = stiff_structure(0.0);
  EXPECT_EQ(leave_out_noisy_lines(set), "");
  set.frfs.clear();
  EXPECT_EQ(leave_out_noisy_lines(set), "");
}

}  // namespace
}  // namespace tapfit::signal
