#include "modal/fit/continue_frfs.hpp"

#include "tests/modal/support/synthetic_frfs.hpp"

#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Eight modes, of which six lie between the lines' ends at 20 and 300 Hz.
class ContinueFrfs : public testing::Test {
 protected:
  ContinueFrfs() {
    system_.frequency_hz = VectorXd(8);
    system_.frequency_hz << 8.0, 40.0, 63.0, 95.0, 150.0, 190.0, 260.0, 420.0;
    system_.damping_ratio = VectorXd::Constant(8, 0.006);
    system_.phi = test::random_shapes(5, 8, random_);
  }

  [[nodiscard]] signal::FrfSet measured(double noise, double sigma = 0.0) {
    return test::roving_hammer(system_,
                               {0, 3},
                               test::line_points(20.0, 300.0, 1121, sigma),
                               noise,
                               random_);
  }
  [[nodiscard]] ModeSet modes(Index first, Index last) const {
    ModeSet set;
    for (Index r = first; r <= last; ++r) {
      const double w = 2.0 * std::numbers::pi * system_.frequency_hz(r);
      const double zeta = system_.damping_ratio(r);
      Mode mode;
      mode.pole = {-zeta * w, w * std::sqrt(1.0 - zeta * zeta)};
      set.modes.push_back(mode);
    }
    return set;
  }
  // Lines at sigma = delta omega, away from the ends by a tenth.
  [[nodiscard]] static VectorXcd damped(double delta) {
    VectorXcd s(120);
    for (Index l = 0; l < s.size(); ++l) {
      const double w =
          2.0 * std::numbers::pi * (23.0 + 2.05 * static_cast<double>(l));
      s(l) = {delta * w, w};
    }
    return s;
  }
  // Largest over FRFs of the rms error over the rms of the truth.
  [[nodiscard]] double error(const signal::FrfSet& set) const {
    double worst = 0.0;
    for (const signal::Frf& frf : set.frfs) {
      VectorXcd truth(set.s.size());
      for (Index l = 0; l < truth.size(); ++l) {
        truth(l) = accelerance(
            system_, frf.response.node - 1, frf.reference.node - 1, set.s(l));
      }
      worst = std::max(worst, (frf.H - truth).norm() / truth.norm());
    }
    return worst;
  }

  std::mt19937_64 random_{7};
  test::SyntheticSystem system_;
};

TEST_F(ContinueFrfs, WithEveryModeIsExactButForWhatLiesBeyondTheLines) {
  for (const double sigma : {0.0, 3.0}) {
    const signal::FrfSet set = measured(0.0, sigma);
    for (const double delta : {0.03, 0.06}) {
      EXPECT_LT(error(continue_frfs(set, modes(1, 6), damped(delta))), 2e-3)
          << sigma << ' ' << delta;
    }
  }
}

// Poisson's integral carries what the modal model does not have.
TEST_F(ContinueFrfs, AModeThatWasNotFoundIsCarriedOnAllTheSame) {
  const signal::FrfSet set = measured(0.0);
  ModeSet without = modes(1, 6);
  without.modes.erase(without.modes.begin() + 3);
  EXPECT_LT(error(continue_frfs(set, without, damped(0.03))), 0.02);
  EXPECT_LT(error(continue_frfs(set, ModeSet{}, damped(0.03))), 0.1);
}

TEST_F(ContinueFrfs, OnTheMeasuredLineIsWhatWasMeasured) {
  const signal::FrfSet set = measured(0.02);
  const signal::FrfSet same = continue_frfs(set, modes(1, 6), set.s);
  ASSERT_EQ(same.frfs.size(), set.frfs.size());
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    EXPECT_LT((same.frfs[f].H - set.frfs[f].H).norm(),
              1e-9 * set.frfs[f].H.norm());
  }
}

// The variance given holds: over many noises the mean square of the deviation
// is what was stated, within the scatter of the study and what smoothing with
// correlated neighbours does (a factor of two).
TEST_F(ContinueFrfs, StatesTheNoiseThatIsLeft) {
  const VectorXcd s = damped(0.03);
  const ModeSet all = modes(1, 6);
  const signal::FrfSet clean = continue_frfs(measured(0.0), all, s);
  VectorXd square = VectorXd::Zero(s.size());
  VectorXd stated = VectorXd::Zero(s.size());
  constexpr int trials = 40;
  for (int k = 0; k < trials; ++k) {
    const signal::FrfSet noisy = continue_frfs(measured(0.02), all, s);
    square += (noisy.frfs[2].H - clean.frfs[2].H).cwiseAbs2();
    stated += noisy.frfs[2].variance;
  }
  const double ratio = square.sum() / stated.sum();
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 2.0);
}

TEST_F(ContinueFrfs, KeepsSignsAndOrder) {
  signal::FrfSet set = measured(0.0);
  set.frfs[1].response.sign = -1;
  set.frfs[1].H = -set.frfs[1].H;
  const signal::FrfSet plain = continue_frfs(measured(0.0), modes(1, 6), set.s);
  const signal::FrfSet turned = continue_frfs(set, modes(1, 6), set.s);
  EXPECT_EQ(turned.frfs[1].response, set.frfs[1].response);
  EXPECT_LT((turned.frfs[1].H + plain.frfs[1].H).norm(),
            1e-9 * plain.frfs[1].H.norm());
}

}  // namespace
}  // namespace tapfit::modal
