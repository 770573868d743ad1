// Elements that have lost part of their stiffness (a crack, corrosion, a weld
// heat zone, delamination): their stiffness times a factor, their mass as it
// was; or thinned (a pocket, wear): their mass times the cube root of it. Where
// it ends within elements, of each layer beside it a factor of its own is left.
#pragma once

#include "updating/effects/stiffness_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

/// What is left of the mass of a plate or a bar that was thinned until p of its
/// bending stiffness was left: t / t_0 = p^(1/3).
[[nodiscard]] double mass_left(double p);
/// d mass_left / d p.
[[nodiscard]] double mass_left_slope(double p);

/// Elements that each parameter after the first scales: with edges the layers
/// beside its own, else none.
[[nodiscard]] std::vector<std::vector<int>> weakened_beside(
    const Where& where, const structure::Deck& deck);

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
  [[nodiscard]] std::vector<std::string> forms() const override {
    return {updating::pocket, updating::edges, updating::pocket_edges};
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
