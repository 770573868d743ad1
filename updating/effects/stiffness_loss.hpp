// Elements that have lost part of their stiffness (a crack, corrosion, a weld
// heat zone, delamination): their stiffness times a factor, their mass as it
// was.
#pragma once

#include "updating/effects/stiffness_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class StiffnessLoss final : public StiffnessEffect {
 public:
  [[nodiscard]] std::string name() const override { return "stiffness-loss"; }
  [[nodiscard]] std::string physics() const override {
    return "elements with less stiffness; lowers the modes that strain them, "
           "in proportion to the strain energy there";
  }
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness()
      const override {
    return updating::ChangeKind::Elements;
  }
  /// Each element, patches of growing size around it, whole properties.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
