// A support of the model that the structure did not have: the test hung free,
// or was pinned where the deck clamps. What the deck holds is released and held
// by nothing.
#include "updating/places/support_groups.hpp"
#include "updating/places/support_line.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace tapfit::effects {
namespace {

std::vector<updating::SupportDof> freed(const Where& where,
                                        const Setting& setting) {
  std::vector<updating::SupportDof> dofs;
  for (const updating::SupportPart& part :
       updating::support_parts(*setting.deck, where.nodes, where.variant)) {
    dofs.insert(dofs.end(), part.line.dofs.begin(), part.line.dofs.end());
  }
  return dofs;
}

class SupportMismatch final : public Effect {
 public:
  SupportMismatch()
      : Effect({.name = "support-mismatch",
                .words = "support that was not there",
                .sits = Sits::OnLine,
                .changes_stiffness = updating::ChangeKind::Support,
                .is_mistake = true,
                .variants = updating::freed_variants()}) {}

  // All supports, then each connected group of constrained grids, free, free to
  // turn, and free to move along each axis; those that hold anything so.
  std::vector<Where> places(const Setting& setting) const override {
    std::vector<Where> result;
    if (setting.deck == nullptr) return result;
    std::vector<std::vector<int>> groups =
        updating::support_choices(*setting.deck);
    if (!groups.empty()) {
      std::rotate(groups.begin(), groups.end() - 1, groups.end());
    }
    for (const std::vector<int>& group : groups) {
      std::size_t most = 0;
      for (const std::string& variant : variants()) {
        Where where{.nodes = group, .variant = variant};
        const std::size_t count = freed(where, setting).size();
        // What frees all that is held is the same under another name.
        if (count == 0 || count == most) continue;
        most = std::max(most, count);
        result.push_back(std::move(where));
      }
    }
    return result;
  }

  std::vector<structure::Constraint> released(
      const Where& where, const Setting& setting) const override {
    std::vector<structure::Constraint> result;
    for (const updating::SupportDof& dof : freed(where, setting)) {
      const std::optional<int> own =
          dof.own_axes ? dof.component
                       : card_component(*setting.deck, dof.node, dof.component);
      if (own) result.push_back({dof.node, std::to_string(*own)});
    }
    return result;
  }

  std::vector<std::string> bulk_data(
      const Where& where,
      const Setting&,
      const std::vector<double>&) const override {
    return {fmt::format("$ Not held in the test: {}", describe(where))};
  }
};

}  // namespace

const Effect& support_mismatch() {
  static const SupportMismatch effect;
  return effect;
}

}  // namespace tapfit::effects
