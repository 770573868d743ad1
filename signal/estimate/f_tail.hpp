// How often Fisher's F lies above a value by chance.
#pragma once

namespace tapfit::signal {

/// P(F > f) with d1 and d2 degrees of freedom; 1 for f of 0 or less.
///
/// It is the incomplete beta function I_x(d2 / 2, d1 / 2) at
/// x = d2 / (d2 + d1 f), by its continued fraction (NIST Digital Library of
/// Mathematical Functions, 8.17.22), to 1e-12 of it.
[[nodiscard]] double f_tail(double f, double d1, double d2);

}  // namespace tapfit::signal
