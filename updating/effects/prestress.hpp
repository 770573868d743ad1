// A member or strip under axial force: a strut bolted in too short, a plate
// held at both ends that has warmed up, a wire that pulls at an end. It
// stiffens what it pulls and softens what it pushes, in proportion to the
// square of each mode's slope along it (preload.hpp). A member with a loose end
// is pulled by a wire, which holds that end across as well.
#pragma once

#include "updating/effects/stiffness_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class Prestress final : public StiffnessEffect {
 public:
  [[nodiscard]] std::string name() const override { return "prestress"; }
  [[nodiscard]] std::string physics() const override {
    return "a member under axial force; pulled it raises the lowest modes "
           "most, pushed it lowers them";
  }
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness()
      const override {
    return updating::ChangeKind::Preload;
  }
  /// Each whole member, pulled, and where both its ends are held, pushed; a
  /// sheet held at both ends across as well.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  /// Besides none: a tension along the member.
  [[nodiscard]] std::vector<std::string> variants() const override {
    return {"compression", "across", "across-compression"};
  }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  /// DMIG K2GG: exact on the deck's own mesh.
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

/// Whether elements make up a member that can be pulled, or pushed, so.
[[nodiscard]] bool can_carry(const structure::Deck& deck, const Where& where);

}  // namespace tapfit::effects
