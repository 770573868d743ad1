// FRFs of a system given by its modes, for tests of identification.
//
//   H_ab(s) = s^2 sum_r phi_ar phi_br / (s^2 + 2 zeta_r w_r s + w_r^2)
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace tapfit::test {

struct SyntheticSystem {
  Eigen::VectorXd frequency_hz;
  Eigen::VectorXd damping_ratio;
  Eigen::MatrixXd phi;  // n_points x n_modes, unit modal mass
};

/// Smooth random shapes: each point a random mixture of sines, so that no
/// point is in a node of all modes.
inline Eigen::MatrixXd random_shapes(Eigen::Index points,
                                     Eigen::Index modes,
                                     std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(
      points, modes, [&] { return normal(random); });
}

/// Modes in 10 to 95 Hz and two above, at 118 and 150 Hz, spaced at random but
/// by at least 0.3 of their mean distance.
inline SyntheticSystem random_system(Eigen::Index modes,
                                     Eigen::Index points,
                                     double low_zeta,
                                     double high_zeta,
                                     std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  SyntheticSystem system;
  system.frequency_hz.resize(modes + 2);
  system.damping_ratio.resize(modes + 2);
  const double gap = 85.0 / static_cast<double>(modes);
  for (Eigen::Index r = 0; r < modes; ++r) {
    const double place = 0.1 + 0.7 * uniform(random);
    system.frequency_hz(r) = 10.0 + gap * (static_cast<double>(r) + place);
  }
  system.frequency_hz(modes) = 118.0;
  system.frequency_hz(modes + 1) = 150.0;
  for (double& zeta : system.damping_ratio) {
    zeta = low_zeta + (high_zeta - low_zeta) * uniform(random);
  }
  system.phi = random_shapes(points, modes + 2, random);
  return system;
}

inline std::complex<double> accelerance(const SyntheticSystem& system,
                                        Eigen::Index a,
                                        Eigen::Index b,
                                        std::complex<double> s) {
  std::complex<double> sum = 0.0;
  for (Eigen::Index r = 0; r < system.frequency_hz.size(); ++r) {
    const double w = 2.0 * std::numbers::pi * system.frequency_hz(r);
    sum += system.phi(a, r) * system.phi(b, r) /
           (s * s + 2.0 * system.damping_ratio(r) * w * s + w * w);
  }
  return s * s * sum;
}

inline Eigen::VectorXcd line_points(double low_hz,
                                    double high_hz,
                                    Eigen::Index lines,
                                    double sigma) {
  Eigen::VectorXcd s(lines);
  for (Eigen::Index k = 0; k < lines; ++k) {
    const double f = low_hz + (high_hz - low_hz) * static_cast<double>(k) /
                                  static_cast<double>(lines - 1);
    s(k) = {sigma, 2.0 * std::numbers::pi * f};
  }
  return s;
}

/// Roving hammer over all points, fixed sensors at the points given.
///
/// @param noise sd of the error of H, relative to the FRF's rms
inline signal::FrfSet roving_hammer(const SyntheticSystem& system,
                                    const std::vector<Eigen::Index>& sensors,
                                    const Eigen::VectorXcd& s,
                                    double noise,
                                    std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  signal::FrfSet set;
  set.s = s;
  for (Eigen::Index hit = 0; hit < system.phi.rows(); ++hit) {
    for (const Eigen::Index sensor : sensors) {
      signal::Frf frf;
      frf.response = {static_cast<int>(sensor) + 1, 3, 1};
      frf.reference = {static_cast<int>(hit) + 1, 3, 1};
      frf.run = static_cast<std::size_t>(hit);
      frf.H.resize(s.size());
      for (Eigen::Index k = 0; k < s.size(); ++k) {
        frf.H(k) = accelerance(system, sensor, hit, s(k));
      }
      const double sd =
          noise * frf.H.norm() / std::sqrt(static_cast<double>(s.size()));
      for (Eigen::Index k = 0; k < s.size(); ++k) {
        frf.H(k) += sd / std::sqrt(2.0) *
                    std::complex<double>(normal(random), normal(random));
      }
      frf.variance = Eigen::VectorXd::Constant(s.size(), sd * sd);
      frf.coherence = Eigen::VectorXd::Ones(s.size());
      frf.hits = 3;
      set.frfs.push_back(frf);
    }
  }
  return set;
}

}  // namespace tapfit::test
