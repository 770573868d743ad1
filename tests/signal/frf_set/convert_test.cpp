#include "signal/frf_set/convert.hpp"

#include "signal/checks/frac.hpp"
#include "signal/checks/frf_quality.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace tapfit::signal {
namespace {

using complex = std::complex<double>;

Eigen::VectorXcd some_lines() {
  Eigen::VectorXcd s(3);
  s << complex(0.0, 0.0), complex(2.0, 10.0), complex(2.0, -7.0);
  return s;
}

TEST(Convert, DividesByS) {
  const Eigen::VectorXcd s = some_lines();
  Eigen::VectorXcd A(3);
  A << complex(1.0, 1.0), complex(3.0, -1.0), complex(0.5, 2.0);
  const Eigen::VectorXcd R =
      convert(A, s, FrfForm::Accelerance, FrfForm::Receptance);
  const Eigen::VectorXcd M =
      convert(A, s, FrfForm::Accelerance, FrfForm::Mobility);
  EXPECT_EQ(R(0), 0.0);
  for (Eigen::Index i = 1; i < 3; ++i) {
    EXPECT_LT(std::abs(R(i) - A(i) / (s(i) * s(i))), 1e-16);
    EXPECT_LT(std::abs(M(i) - A(i) / s(i)), 1e-16);
  }
  const Eigen::VectorXcd back =
      convert(R, s, FrfForm::Receptance, FrfForm::Accelerance);
  EXPECT_LT((back - A).tail(2).norm(), 1e-15);
}

TEST(Frac, IsOneForAFactorAndZeroForOrthogonal) {
  Eigen::VectorXcd a(2);
  a << complex(1e-200, 2e-200), complex(3e-200, 0.0);
  EXPECT_NEAR(frac(a, complex(0.3, -5.0) * a), 1.0, 1e-12);
  Eigen::VectorXcd b(2);
  b << -std::conj(a(1)) * 1e200, std::conj(a(0)) * 1e200;
  EXPECT_NEAR(frac(a, b), 0.0, 1e-12);
  EXPECT_EQ(frac(a, Eigen::VectorXcd::Zero(2)), 0.0);
}

TEST(Frac, IsItsDefinition) {
  Eigen::VectorXcd a(2);
  Eigen::VectorXcd b(2);
  a << complex(1.0, 2.0), complex(0.0, 1.0);
  b << complex(2.0, 0.0), complex(1.0, 1.0);
  // a^H b = (1 - 2j) 2 + (-j)(1 + j) = 3 - 5j; |.|^2 = 34; 6 * 6.
  EXPECT_NEAR(frac(a, b), 34.0 / 36.0, 1e-14);
}

TEST(FrfQuality, AveragesOverTheBand) {
  FrfSet set;
  set.s.resize(3);
  for (Eigen::Index i = 0; i < 3; ++i)
    set.s(i) = {0.0, 2.0 * 3.14159265358979 * static_cast<double>(i + 1)};
  Frf frf;
  frf.H = Eigen::VectorXcd::Constant(3, complex(0.0, 2.0));
  frf.coherence = Eigen::Vector3d(0.2, 0.9, 1.0);
  frf.variance = Eigen::Vector3d(4.0, 0.01, 0.04);
  set.frfs = {frf};
  const auto all = frf_quality(set, std::nullopt);
  EXPECT_NEAR(all[0].mean_coherence, 0.7, 1e-14);
  EXPECT_NEAR(all[0].median_sd_percent, 10.0, 1e-12);
  const auto band = frf_quality(set, std::array{1.5, 10.0});
  EXPECT_NEAR(band[0].mean_coherence, 0.95, 1e-14);
  const auto none = frf_quality(set, std::array{10.0, 20.0});
  EXPECT_EQ(none[0].mean_coherence, 0.0);
  EXPECT_EQ(none[0].median_sd_percent, 0.0);
}

}  // namespace
}  // namespace tapfit::signal
