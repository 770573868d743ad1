// A clamped beam whose tip is loaded or held, as a bundle of modes and by its
// closed form.
#pragma once

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/clamped_beam.hpp"
#include "updating/prediction/stated_change.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

constexpr double beam_kg = 7850.0 * beam_area;

/// Frequencies of the clamped beam, E times `stiffer`, with a mass at its tip
/// of mu times its own: the roots b = beta L of
///
///   1 + cos b cosh b + mu b (cos b sinh b - sin b cosh b) = 0.
///
/// Source: R. D. Blevins, "Formulas for Natural Frequency and Mode Shape",
/// 1979, table 8-8.
inline std::vector<double> beam_with_tip_mass(double mu, double stiffer = 1.0) {
  const auto off = [mu](double b) {
    return 1.0 + std::cos(b) * std::cosh(b) +
           mu * b * (std::cos(b) * std::sinh(b) - std::sin(b) * std::cosh(b));
  };
  const double unit =
      std::sqrt(stiffer * 2.1e11 * beam_inertia / beam_kg) / two_pi;
  std::vector<double> hz;
  constexpr double step = 0.01;
  for (double at = step; hz.size() < 5; at += step) {
    if (off(at) * off(at + step) > 0.0) continue;
    double low = at;
    double high = at + step;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (off(low) * off(middle) > 0.0 ? low : high) = middle;
    }
    hz.push_back(low * low * unit);
  }
  return hz;
}

/// The same with a spring to ground at its tip, kappa = k L^3 / E I:
///
///   1 + cos b cosh b + kappa / b^3 (sin b cosh b - cos b sinh b) = 0.
///
/// Source: as above; kappa = infinity is the clamped and pinned beam.
inline double sprung_beam_fault(double kappa, double b) {
  return 1.0 + std::cos(b) * std::cosh(b) +
         kappa / (b * b * b) *
             (std::sin(b) * std::cosh(b) - std::cos(b) * std::sinh(b));
}

inline std::vector<StatedChange> tip_mass(double kg) {
  return {parse_stated_change(fmt::format("added-mass@21={}", kg))};
}

/// The beam's measured modes, with scatter.
inline void write_beam(const tapfit::testing::TemporaryFolder& folder,
                       double stiffer,
                       const Scatter& scatter) {
  const std::vector<Dof> points = beam_points();
  TrueModes truth = clamped_beam(points);
  for (double& hz : truth.hz) hz *= std::sqrt(stiffer);
  write_modal_bundle(folder,
                     beam_text(),
                     truth,
                     points,
                     scatter,
                     R"(, "uncertain": [{"material": 1, "property": "E"}])");
}

}  // namespace tapfit::updating::testing
