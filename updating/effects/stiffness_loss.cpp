#include "updating/effects/stiffness_loss.hpp"

#include "updating/places/element_patches.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace tapfit::effects {

double mass_left(double p) { return std::cbrt(p); }

double mass_left_slope(double p) { return std::cbrt(p) / (3.0 * p); }

std::vector<Where> StiffnessLoss::places(const Setting& setting) const {
  std::vector<Where> result;
  if (setting.deck == nullptr) return result;
  for (std::vector<int>& patch : updating::element_patches(*setting.deck)) {
    Where where;
    where.elements = std::move(patch);
    result.push_back(std::move(where));
  }
  return result;
}

std::vector<ParameterSpec> StiffnessLoss::parameters(const Where&,
                                                     const Setting&) const {
  return {{"factor", 0.5, 0.04, 1.0}};
}

std::vector<std::string> StiffnessLoss::bulk_data(
    const Where& where, const Setting&, const std::vector<double>& p) const {
  const bool thinned = where.variant == updating::pocket;
  return {fmt::format(
      "$ Stiffness of elements {} times {:.4g}{}: they have a "
      "property and material of their own above",
      fmt::join(where.elements, ", "),
      p[0],
      thinned ? fmt::format(", mass times {:.4g}", mass_left(p[0])) : "")};
}

}  // namespace tapfit::effects
