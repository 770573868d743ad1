#include "updating/set_up/support_mismatch.hpp"

#include "updating/places/support_line.hpp"
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

}  // namespace

std::vector<std::string> SupportMismatch::variants() const {
  return updating::freed_variants();
}

std::vector<Where> SupportMismatch::places(const Setting& setting) const {
  std::vector<Where> result;
  if (setting.deck == nullptr) return result;
  std::vector<std::vector<int>> groups =
      updating::support_groups(*setting.deck);
  if (groups.size() > 1) {
    std::vector<int> all;
    for (const std::vector<int>& group : groups) {
      all.insert(all.end(), group.begin(), group.end());
    }
    groups.insert(groups.begin(), all);
  }
  for (const std::vector<int>& group : groups) {
    std::size_t most = 0;
    for (const std::string& variant : variants()) {
      Where where;
      where.nodes = group;
      where.variant = variant;
      const std::size_t count = freed(where, setting).size();
      // What frees all that is held is the same under another name.
      if (count == 0 || count == most) continue;
      most = std::max(most, count);
      result.push_back(std::move(where));
    }
  }
  return result;
}

std::vector<structure::Constraint> SupportMismatch::released(
    const Where& where, const Setting& setting) const {
  std::vector<structure::Constraint> result;
  for (const updating::SupportDof& dof : freed(where, setting)) {
    const std::optional<int> own =
        dof.own_axes ? dof.component
                     : card_component(*setting.deck, dof.node, dof.component);
    if (own) result.push_back({dof.node, std::to_string(*own)});
  }
  return result;
}

std::vector<std::string> SupportMismatch::bulk_data(
    const Where& where, const Setting&, const std::vector<double>&) const {
  return {fmt::format("$ Not held in the test: {}", describe(where))};
}

}  // namespace tapfit::effects
