#include "modal/poles/cauchy_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// The definition, line by line. The expansions' errors are of the 16th power
// of |w| < 0.175 and of the 12th of a tenth, for the derivative the 11th times
// 12, over the sums of sizes.
TEST(CauchySums, AreTheSumsOverAllLines) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-0.2, 1.2);
  std::uniform_real_distribution<double> decade(-2.0, 3.0);
  for (const Index lines : {9, 63, 64, 65, 500, 4000}) {
    const Eigen::MatrixXcd x = Eigen::MatrixXcd::Random(11, lines);
    const CauchySums sums(x);
    for (int trial = 0; trial < 60; ++trial) {
      const double side = trial % 2 == 0 ? -1.0 : 1.0;
      const Complex a(place(random) * static_cast<double>(lines),
                      side * std::pow(10.0, decade(random)));
      Eigen::VectorXcd once(lines);
      for (Index k = 0; k < lines; ++k) {
        once(k) = 1.0 / (static_cast<double>(k) - a);
      }
      const CauchySums::Pair found = sums.at(a);
      EXPECT_LT((found.first - x * once).cwiseAbs().maxCoeff(),
                1e-10 * once.cwiseAbs().sum());
      EXPECT_LT((found.second - x * once.cwiseAbs2().cwiseProduct(
                                        once.cwiseQuotient(once.conjugate())))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-9 * once.squaredNorm());
    }
  }
}

// Two poles of the same square of the grid, and one of the next: neither what
// was asked for before nor in which order changes a digit.
TEST(CauchySums, DoNotDependOnWhatWasAskedBefore) {
  const Eigen::MatrixXcd x = Eigen::MatrixXcd::Random(3, 200);
  const CauchySums used(x);
  for (const Complex& a : {Complex(80.31, 2.02),
                           Complex(80.32, 2.01),
                           Complex(80.9, 1.9),
                           Complex(80.31, 2.02)}) {
    const CauchySums::Pair again = used.at(a);
    const CauchySums::Pair fresh = CauchySums(x).at(a);
    EXPECT_EQ(again.first, fresh.first);
    EXPECT_EQ(again.second, fresh.second);
  }
}

}  // namespace
}  // namespace tapfit::modal
