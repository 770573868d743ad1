// A system given by its modes with masses added, by Woodbury's formula.
#pragma once

#include "tests/modal/support/synthetic_frfs.hpp"

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

/// Four modes in the band and one above, hit at point 1; each FRF with a sensor
/// of so many kg at its response point only, all FRFs of one set-up.
inline signal::FrfSet one_reference(double kg, double noise) {
  constexpr Eigen::Index points = 6;
  std::mt19937_64 random(3);
  SyntheticSystem system;
  system.frequency_hz.resize(5);
  system.frequency_hz << 15.0, 34.0, 58.0, 81.0, 130.0;
  system.damping_ratio = Eigen::VectorXd::Constant(5, 0.01);
  system.phi = random_shapes(points, 5, random);
  system.phi.row(0).setOnes();
  std::normal_distribution<double> normal;
  signal::FrfSet set;
  set.s = line_points(5, 100, 800, 0.0);
  for (Eigen::Index point = 0; point < points; ++point) {
    signal::Frf frf;
    frf.channel = static_cast<std::size_t>(point) + 1;
    frf.response = {static_cast<int>(point) + 1, 3, 1};
    frf.reference = {1, 3, 1};
    frf.H.resize(set.lines());
    for (Eigen::Index k = 0; k < set.lines(); ++k) {
      frf.H(k) = (1.0 + noise * normal(random)) *
                 loaded_accelerance(system, {point}, kg, point, 0, set.s(k));
    }
    set.frfs.push_back(frf);
  }
  return set;
}

}  // namespace tapfit::test
