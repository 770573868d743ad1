#include "updating/localisation/signature_laws.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tapfit::updating {
namespace {

Signature some_signature() {
  Signature s;
  s.frequency_hz = Eigen::VectorXd::LinSpaced(3, 10.0, 30.0);
  s.mass_kg = 0.2;
  s.mass_unexplained = 0.3;
  s.spring_n_per_m = 500.0;
  s.spring_unexplained = 0.6;
  s.dashpot_ns_per_m = 4.0;
  s.dashpot_unexplained = 0.9;
  return s;
}

// At s = j w: -w^2 m, k, j w c.
TEST(SignatureLaws, AreThoseOfTheirElements) {
  const Signature s = some_signature();
  const auto laws = signature_laws(s);
  ASSERT_EQ(laws.size(), 3U);
  for (Eigen::Index l = 0; l < 3; ++l) {
    const double w = 2.0 * std::numbers::pi * s.frequency_hz(l);
    EXPECT_DOUBLE_EQ(laws[0].shown()(l), -w * w * 0.2);
    EXPECT_DOUBLE_EQ(laws[1].shown()(l), 500.0);
    EXPECT_DOUBLE_EQ(laws[2].shown()(l), w * 4.0);
  }
}

// Its three parameters fit better than one in any case.
TEST(SignatureLaws, AnAbsorberIsTakenWhereOneIsSuspected) {
  Signature s = some_signature();
  EXPECT_EQ(best_law(s, false).effect, "mass");
  EXPECT_EQ(best_law(s, true).effect, "mass") << "there is none";
  s.absorber = {0.05, 20.0, 0.01, 0.1};
  EXPECT_EQ(best_law(s, false).effect, "mass");
  EXPECT_EQ(best_law(s, true).effect, "absorber");
  s.spring_unexplained = 0.2;
  EXPECT_EQ(best_law(s, false).effect, "spring");
}

}  // namespace
}  // namespace tapfit::updating
