// FRFs of made-up values, and their text as a universal file.
#pragma once

#include "signal/files/uff58.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>
#include <string>

namespace tapfit::testing {

using signal::Frf;
using signal::FrfSet;

inline FrfSet some_set(double sigma, bool even = true) {
  FrfSet set;
  set.s.resize(7);
  for (Eigen::Index i = 0; i < 7; ++i) {
    const double x = static_cast<double>(i);
    set.s(i) = {
        sigma,
        2.0 * std::numbers::pi * (1.0 / 3.0 + x / 7.0 + (even ? 0.0 : x * x))};
  }
  for (const int node : {12, 1234567}) {
    Frf frf;
    frf.response = {node, 3, 1};
    frf.reference = {3, 1, -1};
    frf.H.resize(7);
    for (Eigen::Index i = 0; i < 7; ++i)
      frf.H(i) = std::polar(std::exp(static_cast<double>(i - 3 + node % 5)),
                            static_cast<double>(i));
    set.frfs.push_back(frf);
  }
  return set;
}

inline std::string written(const FrfSet& set) {
  std::ostringstream out;
  write_frfs_uff(set, "A test", out);
  return out.str();
}

}  // namespace tapfit::testing
