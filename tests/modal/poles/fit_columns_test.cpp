#include "modal/poles/fit_columns.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// The definition, and derivatives by differences of the first columns: of an
// error of the square of the step.
TEST(FitColumns, ArePolesAndTheirDerivatives) {
  constexpr Complex j(0.0, 1.0);
  Eigen::VectorXcd s(40);
  for (Index k = 0; k < s.size(); ++k) {
    s(k) = {0.2, 1.0 + 0.2 * static_cast<double>(k)};
  }
  Eigen::VectorXcd poles(2);
  poles << Complex(-0.05, 3.0), Complex(-1.0, 6.0);
  const Eigen::MatrixXcd columns = pole_columns(s, poles, 1);
  const Eigen::MatrixXcd derivatives = pole_columns(s, poles, 2);
  constexpr double step = 1e-5;
  const Eigen::VectorXcd moved = (poles.array() + step).matrix();
  const Eigen::VectorXcd back = (poles.array() - step).matrix();
  const Eigen::MatrixXcd differences =
      (pole_columns(s, moved, 1) - pole_columns(s, back, 1)) / (2.0 * step);
  for (Index r = 0; r < poles.size(); ++r) {
    for (Index k = 0; k < s.size(); ++k) {
      const Complex g = s(k) * s(k) / (s(k) - poles(r));
      const Complex h = s(k) * s(k) / (s(k) - std::conj(poles(r)));
      EXPECT_LT(std::abs(columns(k, 2 * r) - (g + h)), 1e-12 * std::abs(g));
      EXPECT_LT(std::abs(columns(k, 2 * r + 1) - j * (g - h)),
                1e-12 * std::abs(g));
    }
  }
  EXPECT_LT((derivatives - differences).norm(), 1e-7 * derivatives.norm());
}

}  // namespace
}  // namespace tapfit::modal
