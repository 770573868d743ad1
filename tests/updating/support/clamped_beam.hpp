// A clamped beam as a deck and by its closed form.
#pragma once

#include "tests/updating/support/modal_bundle.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

/// A clamped beam of 20 bars along x, 1 m of 20 mm x 6 mm steel, bending in z.
constexpr int beam_bars = 20;
constexpr double beam_area = 0.02 * 0.006;
constexpr double beam_inertia = 0.02 * 0.006 * 0.006 * 0.006 / 12.0;

inline std::string beam_text() {
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= beam_bars; ++i) {
    text +=
        fmt::format("GRID,{},,{},0.,0.,,1246\n", i + 1, double(i) / beam_bars);
  }
  for (int i = 1; i <= beam_bars; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  }
  text += fmt::format("PBAR,1,1,{},{},{},{}\n",
                      beam_area,
                      beam_inertia,
                      beam_inertia,
                      2.0 * beam_inertia);
  return text + "MAT1,1,2.1+11,,.3,7850.\nSPC1,1,123456,1\nENDDATA\n";
}

/// Euler-Bernoulli: f = (beta L)^2 / 2 pi sqrt(E I / rho A L^4), and the shapes
/// that go with it.
inline TrueModes clamped_beam(const std::vector<Dof>& points) {
  constexpr std::array<double, 5> roots{
      1.875104069, 4.694091133, 7.854757438, 10.99554073, 14.13716839};
  TrueModes truth;
  truth.shape.resize(static_cast<Eigen::Index>(points.size()), roots.size());
  for (std::size_t r = 0; r < roots.size(); ++r) {
    const double b = roots[r];
    truth.hz.push_back(b * b / (2.0 * std::numbers::pi) *
                       std::sqrt(2.1e11 * beam_inertia / 7850.0 / beam_area));
    const double g =
        (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double x = b * (points[k].node - 1) / beam_bars;
      truth.shape(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(r)) =
          std::cosh(x) - std::cos(x) - g * (std::sinh(x) - std::sin(x));
    }
  }
  if (!points.empty()) truth.shape.colwise().normalize();
  return truth;
}

inline std::vector<Dof> beam_points() {
  return {{5, 3, 1}, {9, 3, 1}, {13, 3, 1}, {17, 3, 1}, {21, 3, 1}};
}

}  // namespace tapfit::updating::testing
