#include "signal/statistics/tail_probability.hpp"

#include <cmath>

namespace tapfit::signal {
namespace {

constexpr int most_terms = 10000;
constexpr double enough = 1e-14;
constexpr double tiny = 1e-300;

// std::lgamma writes the sign into a global: not for several threads.
double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

double away_from_zero(double x) { return std::abs(x) < tiny ? tiny : x; }

/// Continued fraction of I_x(a, b) by Lentz; fast for x < (a + 1)/(a + b + 2).
double beta_fraction(double x, double a, double b) {
  double c = 1.0;
  double d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
  double h = d;
  for (int m = 1; m < most_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
    d = 1.0 / away_from_zero(1.0 + even * d);
    c = away_from_zero(1.0 + even / c);
    h *= d * c;
    const double odd =
        -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
    d = 1.0 / away_from_zero(1.0 + odd * d);
    c = away_from_zero(1.0 + odd / c);
    h *= d * c;
    if (std::abs(d * c - 1.0) < enough) break;
  }
  return h;
}

double incomplete_beta(double x, double a, double b) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front = std::exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) +
                                a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1.0) / (a + b + 2.0)) return front * beta_fraction(x, a, b) / a;
  return 1.0 - front * beta_fraction(1.0 - x, b, a) / b;
}

/// P(a, x) by its series, for x < a + 1.
double gamma_series(double a, double x) {
  double term = 1.0 / a;
  double sum = term;
  for (int n = 1; n < most_terms && term > enough * sum; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum;
}

/// Q(a, x) by its continued fraction, for x >= a + 1.
double gamma_fraction(double a, double x) {
  double b = x + 1.0 - a;
  double c = 1.0 / tiny;
  double d = 1.0 / b;
  double h = d;
  for (int n = 1; n < most_terms; ++n) {
    const double an = -n * (n - a);
    b += 2.0;
    d = 1.0 / away_from_zero(an * d + b);
    c = away_from_zero(b + an / c);
    h *= d * c;
    if (std::abs(d * c - 1.0) < enough) break;
  }
  return h;
}

}  // namespace

double f_tail(double f, double d1, double d2) {
  if (!(f > 0.0)) return 1.0;
  return incomplete_beta(d2 / (d2 + d1 * f), 0.5 * d2, 0.5 * d1);
}

double chi_squared_tail(double c, double d) {
  if (!(c > 0.0)) return 1.0;
  const double a = 0.5 * d;
  const double x = 0.5 * c;
  const double front = std::exp(a * std::log(x) - x - log_gamma(a));
  return x < a + 1.0 ? 1.0 - front * gamma_series(a, x)
                     : front * gamma_fraction(a, x);
}

double t_95(double d) {
  double low = 0.0;
  double high = 1e3;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (f_tail(middle * middle, 1.0, d) > 0.05 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace tapfit::signal
