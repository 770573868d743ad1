// The units that a model's numbers may be in, beside SI.
#pragma once

#include <optional>
#include <string>

namespace tapfit {

/// SI units per unit of the model; seconds stay seconds.
struct ModelUnits {
  double length = 1.0;  ///< [m]
  double mass = 1.0;    ///< [kg]
};

/// @param name "SI" (or nothing), "mm-t-s", "in-lbf-s"
/// @return empty for another one
[[nodiscard]] std::optional<ModelUnits> model_units(const std::string& name);

}  // namespace tapfit
