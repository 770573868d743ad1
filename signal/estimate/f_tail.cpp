#include "signal/estimate/f_tail.hpp"

#include <cmath>

namespace tapfit::signal {
namespace {

// The continued fraction of I_x(a, b) a / (x^a (1 - x)^b) B(a, b), by Lentz's
// method; quick for x < (a + 1) / (a + b + 2).
double fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  constexpr int most = 1000;
  const auto apart = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double c = 1.0;
  double d = 1.0 / apart(1.0 - (a + b) * x / (a + 1.0));
  double result = d;
  for (int m = 1; m < most; ++m) {
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    const double odd =
        -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    double step = 1.0;
    for (const double term : {even, odd}) {
      d = 1.0 / apart(1.0 + term * d);
      c = apart(1.0 + term / c);
      step = c * d;
      result *= step;
    }
    if (std::abs(step - 1.0) < 1e-13) break;
  }
  return result;
}

double incomplete_beta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  if (x > (a + 1.0) / (a + b + 2.0))
    return 1.0 - incomplete_beta(b, a, 1.0 - x);
  const double log_front = a * std::log(x) + b * std::log1p(-x) +
                           std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b);
  return std::exp(log_front) / a * fraction(a, b, x);
}

}  // namespace

double f_tail(double f, double d1, double d2) {
  if (!(f > 0.0)) return 1.0;
  return incomplete_beta(0.5 * d2, 0.5 * d1, d2 / (d2 + d1 * f));
}

}  // namespace tapfit::signal
