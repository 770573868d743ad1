#include "signal/frf_set/linearity_finding.hpp"

#include <fmt/format.h>

namespace tapfit::signal {
namespace {

// Of 500 tests of a linear structure one is suspected.
constexpr double sure = 1.0 / 500.0;
constexpr double worth_saying = 0.01;

}  // namespace

bool LinearityFinding::is_nonlinear() const {
  return p_value <= sure && change >= worth_saying;
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
