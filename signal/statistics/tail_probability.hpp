// How likely a test statistic is to be as large by chance.
//
//   F:     P(F > f) = I_x(d2 / 2, d1 / 2),   x = d2 / (d2 + d1 f)
//   chi^2: P(X > c) = Q(d / 2, c / 2)
//   t:     two-sided P(|T| > t) = P(F(1, d) > t^2)
//
// Source: NIST Digital Library of Mathematical Functions, 8.17.22 (continued
// fraction of the incomplete beta function), 8.7.1 and 8.9.2 (incomplete gamma
// function).
#pragma once

namespace tapfit::signal {

/// P(F > f) for d1 and d2 degrees of freedom, both above 0; 1 for f <= 0.
[[nodiscard]] double f_tail(double f, double d1, double d2);

/// P(X > c) for d degrees of freedom above 0; 1 for c <= 0.
[[nodiscard]] double chi_squared_tail(double c, double d);

/// The t that |T| stays below with probability 0.95, d degrees of freedom.
[[nodiscard]] double t_95(double d);

}  // namespace tapfit::signal
