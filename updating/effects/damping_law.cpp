// One law for the damping of every mode, in place of a ratio for each: viscous
// in proportion to mass and stiffness (Rayleigh) and structural,
//
//   2 zeta omega = alpha + beta omega^2 + eta omega.
//
// Structural damping is taken as the viscous one that takes as much energy from
// a mode at its own frequency, zeta = eta / 2.
#include "updating/effects/effects.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::effects {
namespace {

class DampingLaw final : public Effect {
 public:
  DampingLaw()
      : Effect({.name = "damping-law",
                .words = "law of damping",
                .entry = Entry::Damping,
                .law = Law::Own}) {}

  std::vector<Location> places(const TestContext&) const override {
    return {Location{}};
  }

  std::vector<ParameterSpec> parameters(
      const Location&, const TestContext& context) const override {
    // Of each alone a mode in the middle of the band has these ratios.
    constexpr double least = 1e-6;
    constexpr double start = 0.003;
    constexpr double most = 0.3;
    const double w = two_pi * std::sqrt(context.low_hz * context.high_hz);
    const auto spec = [](const char* name, double unit) {
      return ParameterSpec{
          name, 2.0 * start * unit, 2.0 * least * unit, 2.0 * most * unit};
    };
    return {spec("viscous_alpha", w),
            spec("viscous_beta", 1.0 / w),
            spec("structural_eta", 1.0)};
  }

  ModeDamping mode_damping(double omega, std::size_t k) const override {
    if (k == 0) return {1.0, 0.0};
    if (k == 1) return {omega * omega, 2.0 * omega};
    return {omega, 1.0};
  }

  std::vector<std::string> bulk_data(
      const Location&,
      const TestContext&,
      const std::vector<double>& p) const override {
    return {fmt::format("PARAM,ALPHA1,{:.8g}", p[0]),
            fmt::format("PARAM,ALPHA2,{:.8g}", p[1]),
            fmt::format("PARAM,G,{:.8g}", p[2])};
  }
};

}  // namespace

const Effect& damping_law() {
  static const DampingLaw effect;
  return effect;
}

}  // namespace tapfit::effects
