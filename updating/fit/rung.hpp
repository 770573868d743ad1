// A rung of the error ladder: what was added, and the error then.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Names of the rungs that are no effects.
inline constexpr const char* base_rung = "base";
inline constexpr const char* uncertain_rung = "uncertain properties";

struct Rung {
  std::string added;  ///< effect, or one of the names above
  Location where;
  double error = 0.0;
  std::vector<Estimate> parameters;
  double probability = 1.0;  ///< among all tried with the same other effects
  std::vector<EffectRef> alike = {};  ///< what explains the data as well
  int stopped_after = 0;  ///< steps, where its fit was ended by hand, else 0
  std::vector<double> place_sd = {};  ///< see EffectRef; the parameters hold it
  std::vector<double> sizes = {};     ///< of the fit with all rungs
};

/// The most probable kind of a rung that may name a group: "a" of "a|b".
[[nodiscard]] std::string leading_kind(const Rung& rung);

}  // namespace tapfit::updating
