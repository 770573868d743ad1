#include "acquisition/foundation/model_units.hpp"

namespace tapfit {

std::optional<ModelUnits> model_units(const std::string& name) {
  constexpr double inch = 0.0254;
  constexpr double pound_force = 4.4482216152605;
  if (name.empty() || name == "SI") return ModelUnits{};
  if (name == "mm-t-s") return ModelUnits{1e-3, 1e3};
  // A pound-force accelerates its mass by an inch per second squared.
  if (name == "in-lbf-s") return ModelUnits{inch, pound_force / inch};
  return std::nullopt;
}

}  // namespace tapfit
