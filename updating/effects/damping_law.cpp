#include "updating/effects/damping_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::effects {

std::vector<ParameterSpec> DampingLaw::parameters(
    const Where&, const Setting& setting) const {
  // Of each alone a mode in the middle of the band has these ratios.
  constexpr double least = 1e-6;
  constexpr double start = 0.003;
  constexpr double most = 0.3;
  const double w =
      2.0 * std::numbers::pi * std::sqrt(setting.low_hz * setting.high_hz);
  const auto spec = [](const char* name, double unit) {
    return ParameterSpec{
        name, 2.0 * start * unit, 2.0 * least * unit, 2.0 * most * unit};
  };
  return {spec("viscous_alpha", w),
          spec("viscous_beta", 1.0 / w),
          spec("structural_eta", 1.0)};
}

ModeDamping DampingLaw::mode_damping(double omega, std::size_t k) const {
  if (k == 0) return {1.0, 0.0};
  if (k == 1) return {omega * omega, 2.0 * omega};
  return {omega, 1.0};
}

std::vector<std::string> DampingLaw::bulk_data(
    const Where&, const Setting&, const std::vector<double>& p) const {
  return {fmt::format("PARAM,ALPHA1,{:.8g}", p[0]),
          fmt::format("PARAM,ALPHA2,{:.8g}", p[1]),
          fmt::format("PARAM,G,{:.8g}", p[2])};
}

}  // namespace tapfit::effects
