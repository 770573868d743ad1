// A system given by its modes with masses added, by Woodbury's formula.
#pragma once

#include "tests/modal/synthetic_frfs.hpp"

#include <Eigen/Dense>

#include <complex>
#include <vector>

namespace tapfit::test {

/// Accelerance with masses of `kg` at the points of `at`.
inline std::complex<double> loaded_accelerance(
    const SyntheticSystem& system,
    const std::vector<Eigen::Index>& at,
    double kg,
    Eigen::Index a,
    Eigen::Index b,
    std::complex<double> s) {
  const auto k = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixXcd core = Eigen::MatrixXcd::Identity(k, k);
  Eigen::VectorXcd row(k);
  Eigen::VectorXcd column(k);
  for (Eigen::Index t = 0; t < k; ++t) {
    const Eigen::Index p = at[static_cast<std::size_t>(t)];
    row(t) = accelerance(system, a, p, s);
    column(t) = accelerance(system, p, b, s);
    for (Eigen::Index u = 0; u < k; ++u) {
      core(t, u) +=
          kg * accelerance(system, p, at[static_cast<std::size_t>(u)], s);
    }
  }
  return accelerance(system, a, b, s) -
         kg * row.cwiseProduct(core.inverse() * column).sum();
}

}  // namespace tapfit::test
