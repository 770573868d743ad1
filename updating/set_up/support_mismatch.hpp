// Supports of the model that are not those of the test.
//
// One that the structure did not have: the test hung free, or was pinned where
// the deck clamps. What the deck holds is released and held by nothing.
//
// One that the deck does not have: the test was clamped or stood on something
// where the deck is free. What moves there is held (held_motions.hpp).
#pragma once

#include "updating/effects/stiffness_effect.hpp"

namespace tapfit::effects {

class SupportMismatch final : public StiffnessEffect {
 public:
  [[nodiscard]] std::string name() const override { return "support-mismatch"; }
  [[nodiscard]] std::string physics() const override {
    return "a support of the model that the structure did not have, or the "
           "reverse; the first modes are others, down to the rigid ones";
  }
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness()
      const override {
    return updating::ChangeKind::Support;
  }
  [[nodiscard]] bool is_mistake() const override { return true; }
  /// All supports, then each connected group of constrained grids, free, free
  /// to turn, and free to move along each axis; those that hold anything so.
  /// Of a deck that nothing holds each of clamp_places(), held and held as by a
  /// hinge: that a structure is held elsewhere than in its deck, besides, is
  /// tried by name.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> variants() const override;
  /// Held along one axis only, where a hinge does well.
  [[nodiscard]] std::vector<std::string> forms() const override;
  [[nodiscard]] bool takes(const std::string& form,
                           const Where& place,
                           const Setting& setting) const override;
  /// None: nothing is left of what held, or nothing gives.
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where&, const Setting&) const override {
    return {};
  }
  [[nodiscard]] std::vector<structure::Constraint> released(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
