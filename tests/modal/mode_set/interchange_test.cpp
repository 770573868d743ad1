// Modes and synthesised FRFs that left as universal files and came back, held
// against the closed form of a structure whose shapes are complex:
//
//   H(s) = s^2 (M s^2 + C s + K)^-1
#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/read_modes_uff.hpp"
#include "modal/mode_set/synthesis.hpp"
#include "modal/mode_set/uff55.hpp"
#include "signal/files/uff58.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Four masses of 1 kg in a row between walls, one dashpot at an end: the
/// points of a mode do not move in phase.
Eigen::MatrixXcd accelerances(const Complex& s) {
  Eigen::Matrix4d K = Eigen::Matrix4d::Zero();
  for (int k = 0; k < 4; ++k) {
    K(k, k) = 2.0e4;
    if (k > 0) K(k, k - 1) = K(k - 1, k) = -1.0e4;
  }
  Eigen::Matrix4d C = 1e-4 * K;
  C(3, 3) += 12.0;
  const Eigen::Matrix4cd Z = s * s * Eigen::Matrix4cd::Identity() +
                             s * C.cast<Complex>() + K.cast<Complex>();
  return s * s * Z.inverse();
}

/// A roving hammer past sensors at the first and the third mass.
signal::FrfSet measured(double sigma) {
  signal::FrfSet set;
  set.s = test::line_points(5.0, 45.0, 401, sigma);
  for (int hit = 0; hit < 4; ++hit) {
    for (const int sensor : {0, 2}) {
      signal::Frf frf;
      frf.response = {sensor + 1, 1, 1};
      frf.reference = {hit + 1, 1, hit == 1 ? -1 : 1};
      frf.run = static_cast<std::size_t>(hit);
      frf.hits = 3;
      frf.H.resize(set.lines());
      for (Index k = 0; k < set.lines(); ++k) {
        frf.H(k) =
            accelerances(set.s(k))(sensor, hit) * double(frf.reference.sign);
      }
      frf.coherence = Eigen::VectorXd::Ones(set.lines());
      frf.variance = Eigen::VectorXd::Zero(set.lines());
      set.frfs.push_back(std::move(frf));
    }
  }
  return set;
}

/// Largest difference to the closed form, relative to its largest value.
double error_of(const ModeSet& modes, int a, int b) {
  const Eigen::VectorXcd s = test::line_points(5.0, 45.0, 97, 0.2);
  const auto H = synthesise(modes, {a + 1, 1, 1}, {b + 1, 1, 1}, s);
  if (!H) return 1e300;
  double error = 0.0;
  double largest = 0.0;
  for (Index k = 0; k < s.size(); ++k) {
    const Complex exact = accelerances(s(k))(a, b);
    error = std::max(error, std::abs((*H)(k)-exact));
    largest = std::max(largest, std::abs(exact));
  }
  return error / largest;
}

TEST(Interchange, ComplexModesComeBackAsTheStructureTheyAreOf) {
  const ModeSet found = identify_modes(measured(0.2), {});
  ASSERT_EQ(found.modes.size(), 4U);
  ASSERT_TRUE(found.scaled);
  double least_mpc = 1.0;
  for (const Mode& mode : found.modes) {
    least_mpc = std::min(least_mpc, mode.mpc);
  }
  EXPECT_LT(least_mpc, 0.985) << "the shapes are to be complex";
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) EXPECT_LT(error_of(found, a, b), 1e-6);
  }
  for (const ModeDataset as : {ModeDataset::Uff55, ModeDataset::Uff2414}) {
    const ModeSet read =
        read_modes_uff_text(modes_as_uff(found, "A chain", as), "memory").set;
    // The files hold six digits; those of a pole count 1 / zeta times as much
    // at its resonance, and zeta is 0.003 here at the least.
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) EXPECT_LT(error_of(read, a, b), 5e-4);
    }
  }
}

TEST(Interchange, SynthesisedFrfsComeBackAsTheClosedForm) {
  for (const double sigma : {0.0, 0.7}) {
    const signal::FrfSet given = measured(sigma);
    const ModeSet found = identify_modes(given, {});
    const testing::TemporaryFolder folder;
    const auto file = folder.path() / "fit.uff";
    signal::write_frfs_uff(fitted_set(given, found), "A chain", file, {});
    const signal::FrfSet read = signal::read_frfs_uff(file).set;
    ASSERT_EQ(read.frfs.size(), given.frfs.size());
    ASSERT_EQ(read.lines(), given.lines());
    EXPECT_LT((read.s - given.s).norm(), 1e-6 * given.s.norm());
    for (std::size_t f = 0; f < read.frfs.size(); ++f) {
      const signal::Frf& frf = read.frfs[f];
      EXPECT_EQ(signal::name(frf), signal::name(given.frfs[f]));
      EXPECT_LT((frf.H - given.frfs[f].H).norm(),
                1e-5 * given.frfs[f].H.norm());
    }
  }
}

}  // namespace
}  // namespace tapfit::modal
