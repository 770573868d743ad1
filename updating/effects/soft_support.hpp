// A support that gives way: the constrained rotation (about the clamp's line)
// or translation is released and held by springs, k per metre of clamp. Its
// forms have both, a k that runs linearly from one end of the line to the
// other, or one k per area of the face (support_face.hpp).
#pragma once

#include "updating/effects/stiffness_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class SoftSupport final : public StiffnessEffect {
 public:
  [[nodiscard]] std::string name() const override { return "soft-support"; }
  [[nodiscard]] std::string physics() const override {
    return "a support that gives; lowers the first modes most, where the "
           "support carries them";
  }
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness()
      const override {
    return updating::ChangeKind::Support;
  }
  /// Each connected group of constrained grids, and all of them together; the
  /// rotation and the translation of each that is held.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> forms() const override;
  [[nodiscard]] bool takes(const std::string& form,
                           const Where& place,
                           const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<Derived> derived(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<structure::Constraint> released(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
