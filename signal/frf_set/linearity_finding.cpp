#include "signal/frf_set/linearity_finding.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

// Very strong evidence, as an effect must have it: of some 3,000 tests of a
// linear structure one is suspected.
constexpr double very_strong = 1.0 / 150.0;
constexpr double worth_saying = 0.01;

// Odds of chance against the alternative that suits a p-value best, -e p ln p
// (T. Sellke, M. Bayarri, J. Berger, "Calibration of p Values for Testing
// Precise Null Hypotheses", The American Statistician 55(1), 2001).
double least_odds_of_chance(double p) {
  return p < 1.0 / std::numbers::e ? -std::numbers::e * p * std::log(p) : 1.0;
}

}  // namespace

bool LinearityFinding::is_nonlinear() const {
  return least_odds_of_chance(p_value) < very_strong && change >= worth_saying;
}

std::string statement(const LinearityFinding& finding) {
  if (!finding.is_nonlinear()) return {};
  return fmt::format(
      "the FRFs change with the force of the hits: by about {:.2g} % from the "
      "weakest to the strongest of a run (1 to {:.2g}). A linear model does "
      "not; look for play, friction or large motions, and hit evenly",
      100.0 * finding.change,
      finding.level_ratio);
}

}  // namespace tapfit::signal
