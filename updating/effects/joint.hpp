// A joint that gives: along a line of grids the elements on one side turn
// against the rest, held by a spring, k per metre of line. A bolted or bonded
// seam, a weld that did not take. Its form "crack" parts them over some of the
// line's grids, held by k per area of the two faces: next to nothing for a
// crack that is open, more for one that is bonded or rubs.
#pragma once

#include "updating/effects/stiffness_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class Joint final : public StiffnessEffect {
 public:
  [[nodiscard]] std::string name() const override { return "joint"; }
  [[nodiscard]] std::string physics() const override {
    return "a seam that turns; lowers the modes that bend across it, leaves "
           "those that do not";
  }
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness()
      const override {
    return updating::ChangeKind::Joint;
  }
  /// Each straight line across shells, lines in line with each other
  /// together, each place where bars meet.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> forms() const override {
    return {updating::crack};
  }
  /// A crack at a line of shells.
  [[nodiscard]] bool takes(const std::string& form,
                           const Where& place,
                           const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<Derived> derived(
      const Where& where, const Setting& setting) const override;
  /// Of what the elements on one side need besides: see joint_cards.hpp.
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
