// Identified parameters as results: value, standard deviation, interval.
#pragma once

#include "updating/fit/estimate.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/fit/rung.hpp"
#include "updating/properties/uncertain_parts.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Name, unit, nominal value and prior of an uncertain property.
struct PropertyName {
  std::string name;
  std::string unit;
  double nominal = 0.0;
  double prior_sd = 0.0;  ///< of ln(value / nominal)
};

/// "added-mass", or "added-mass (node 5)" where it is not alone of its kind.
[[nodiscard]] std::string label_of(const std::vector<EffectInstance>& effects,
                                   std::size_t own);

/// Parameters of the fit's effect at a position, with derived ones (a total
/// from a value per metre), as unsure as the fit and the effect's place are.
[[nodiscard]] std::vector<Estimate> effect_estimates(
    const Fit& fit, std::size_t effect, const effects::TestContext& context);

/// The uncertain base properties of the fit, in their own units.
[[nodiscard]] std::vector<Estimate> property_estimates(
    const Fit& fit, const std::vector<PropertyName>& names);

/// Both, the effects' as "EFFECT NAME".
[[nodiscard]] std::vector<Estimate> all_estimates(
    const Fit& fit,
    const std::vector<PropertyName>& names,
    const effects::TestContext& context);

/// The error ladder of successive fits: base, what is uncertain in it (a fit
/// without effects), then one rung per effect.
[[nodiscard]] std::vector<Rung> rungs_of(const std::vector<Fit>& fits,
                                         const effects::TestContext& context);

}  // namespace tapfit::updating
