#include "updating/session/weighed_mass.hpp"

#include "acquisition/foundation/unit_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// Screws, glue and paint are seldom in a deck.
constexpr double usual = 0.05;
constexpr double certain = 3.0;  // standard deviations

// Relative, as if all of the mass were of the part that is known least.
double deck_sd(const acquisition::TestBundle& bundle) {
  double sd = 0.0;
  for (const acquisition::UncertainProperty& u : bundle.uncertain) {
    const bool weighs =
        u.property == "rho" || u.property == "t" || u.property == "A";
    if (weighs) sd = std::max(sd, 0.01 * u.sd_percent);
  }
  return sd;
}

}  // namespace

std::optional<Finding> weighed_mass_finding(
    const acquisition::TestBundle& bundle, double deck_kg) {
  if (!bundle.weighed || !(deck_kg > 0.0)) return {};
  const double kg = bundle.weighed->mass_kg;
  const double sd =
      std::hypot(0.01 * bundle.weighed->sd_percent, deck_sd(bundle));
  const double ratio = kg / deck_kg;
  if (std::abs(std::log(ratio)) <= std::log1p(std::max(usual, certain * sd))) {
    return {};
  }
  const std::string unit = acquisition::mass_slip(ratio);
  return Finding{
      Severity::Warning,
      {},
      fmt::format("the structure was weighed at {} kg, {} times the {} kg of "
                  "the deck",
                  in_digits(kg, 4),
                  in_digits(ratio, 3),
                  in_digits(deck_kg, 4)),
      unit.empty()
          ? std::string("parts or masses are missing from the deck or too "
                        "many, or a density or thickness, or \"weighed\" in "
                        "test.json, is wrong")
          : "a density, or \"weighed\" in test.json, is in another unit (" +
                unit + ")",
      "compare the deck's parts with what lay on the scale; `weighed` is "
      "mass_kg of the structure without sensors"};
}

}  // namespace tapfit::updating
