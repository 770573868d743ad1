// Plates told by closed form, drawn at random, and how well their modes are
// found: for tests and studies of identification.
#pragma once

#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/mac.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace tapfit::test {

struct RandomPlate {
  SyntheticSystem system;
  Eigen::Index in_band = 0;
  double low_hz = 0.0;
  double high_hz = 0.0;
  std::vector<Eigen::Index> sensors;
};

/// A simply supported rectangular plate of 4 kg:
///   f_mn = c ((m / a)^2 + (n / b)^2),
///   phi_mn = 2 sin(m pi x / a) sin(n pi y / b) / sqrt(M)
/// measured at 24 to 40 random points with three sensors among them. The band
/// holds 8 to 20 modes and ends half way to the first mode that lies at least
/// 1 % above the one below.
inline RandomPlate random_plate(std::mt19937_64& random) {
  using std::numbers::pi;
  std::uniform_real_distribution<double> uniform;
  const double aspect = 1.0 + uniform(random);
  struct Wave {
    int m, n;
    double f;
  };
  std::vector<Wave> waves;
  for (int m = 1; m < 20; ++m) {
    for (int n = 1; n < 20; ++n) {
      waves.push_back({m, n, m * m / (aspect * aspect) + n * n});
    }
  }
  std::ranges::sort(waves, {}, &Wave::f);
  RandomPlate plate;
  auto last = static_cast<std::size_t>(8.0 + 12.99 * uniform(random)) - 1;
  while (waves[last + 1].f / waves[last].f < 1.01) --last;
  plate.in_band = static_cast<Eigen::Index>(last) + 1;
  const double scale = 1000.0 / waves[last].f;
  plate.low_hz = 0.5 * scale * waves.front().f;
  plate.high_hz = 0.5 * scale * (waves[last].f + waves[last + 1].f);
  // Modes to twice the band.
  std::erase_if(waves, [&](const Wave& wave) {
    return wave.f * scale > 2.0 * plate.high_hz;
  });
  const auto modes = static_cast<Eigen::Index>(waves.size());
  const auto points = static_cast<Eigen::Index>(24.0 + 16.0 * uniform(random));
  SyntheticSystem& system = plate.system;
  system.frequency_hz.resize(modes);
  system.damping_ratio.resize(modes);
  system.phi.resize(points, modes);
  for (Eigen::Index r = 0; r < modes; ++r) {
    system.frequency_hz(r) = scale * waves[static_cast<std::size_t>(r)].f;
    system.damping_ratio(r) = 0.002 + 0.008 * uniform(random);
  }
  for (Eigen::Index p = 0; p < points; ++p) {
    const double x = 0.05 + 0.9 * uniform(random);
    const double y = 0.05 + 0.9 * uniform(random);
    for (Eigen::Index r = 0; r < modes; ++r) {
      const Wave& wave = waves[static_cast<std::size_t>(r)];
      system.phi(p, r) = std::sin(wave.m * pi * x) * std::sin(wave.n * pi * y);
    }
  }
  plate.sensors = {0, 1, 2};
  return plate;
}

/// FRFs of a hammer that roves over the plate's points, on 1,500 lines.
inline signal::FrfSet measure(const RandomPlate& plate,
                              double noise,
                              std::mt19937_64& random) {
  return roving_hammer(plate.system,
                       plate.sensors,
                       line_points(plate.low_hz, plate.high_hz, 1500, 0.0),
                       noise,
                       random);
}

/// Largest errors of the modes found, each against the one in its place.
struct PlateErrors {
  double frequency = 0.0;  ///< relative
  double damping = 0.0;    ///< relative
  double mac = 1.0;        ///< least
};

/// Nothing where there are more or fewer modes than the band holds.
inline std::optional<PlateErrors> errors_of(const modal::ModeSet& found,
                                            const RandomPlate& plate) {
  if (static_cast<Eigen::Index>(found.modes.size()) != plate.in_band) return {};
  PlateErrors worst;
  for (Eigen::Index r = 0; r < plate.in_band; ++r) {
    const modal::Mode& mode = found.modes[static_cast<std::size_t>(r)];
    const SyntheticSystem& truth = plate.system;
    worst.frequency =
        std::max(worst.frequency,
                 std::abs(mode.frequency_hz / truth.frequency_hz(r) - 1.0));
    worst.damping =
        std::max(worst.damping,
                 std::abs(mode.damping_ratio / truth.damping_ratio(r) - 1.0));
    const Eigen::VectorXcd phi = truth.phi.col(r).cast<std::complex<double>>();
    worst.mac = std::min(worst.mac, modal::mac(mode.shape, phi)(0, 0));
  }
  return worst;
}

}  // namespace tapfit::test
