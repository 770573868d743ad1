#include "updating/effects/soft_support.hpp"

#include "updating/effects/deck_cards.hpp"
#include "updating/support_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::effects {
namespace {

updating::SupportLine line_of(const Where& where, const Setting& setting) {
  return updating::support_line(*setting.deck,
                                where.nodes,
                                where.variant == "rotation",
                                setting.component);
}

std::string base_name(const Where& where) {
  return where.variant == "rotation" ? "rotational_stiffness_nm_per_rad"
                                     : "translational_stiffness_n_per_m";
}

}  // namespace

std::vector<Where> SoftSupport::places(const Setting& setting) const {
  std::vector<Where> result;
  if (setting.deck == nullptr) return result;
  std::vector<std::vector<int>> groups =
      updating::support_groups(*setting.deck);
  if (groups.size() > 1) {
    std::vector<int> all;
    for (const std::vector<int>& group : groups) {
      all.insert(all.end(), group.begin(), group.end());
    }
    groups.push_back(all);
  }
  for (const std::vector<int>& group : groups) {
    for (const char* variant : {"rotation", "translation"}) {
      Where where;
      where.nodes = group;
      where.variant = variant;
      if (!line_of(where, setting).dofs.empty()) result.push_back(where);
    }
  }
  return result;
}

std::vector<ParameterSpec> SoftSupport::parameters(
    const Where& where, const Setting& setting) const {
  // The scale at which a support is as soft as the structure's inertia is
  // heavy at the band's ends; the fit starts from a scan over this range.
  const double length = line_of(where, setting).length;
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double high = 2.0 * std::numbers::pi * setting.high_hz;
  const double size = where.variant == "rotation" ? 0.1 : 1.0;
  const double lower = 1e-2 * setting.mass_kg * low * low * size / length;
  const double upper = 1e4 * setting.mass_kg * high * high * size / length;
  return {
      {base_name(where) + "_per_m", std::sqrt(lower * upper), lower, upper}};
}

std::vector<Effect::Derived> SoftSupport::derived(
    const Where& where, const Setting& setting) const {
  return {{base_name(where), line_of(where, setting).length}};
}

std::vector<structure::Constraint> SoftSupport::released(
    const Where& where, const Setting& setting) const {
  std::vector<structure::Constraint> result;
  for (const updating::SupportDof& dof : line_of(where, setting).dofs) {
    const auto own = card_component(*setting.deck, dof.node, dof.component);
    if (own) result.push_back({dof.node, std::to_string(*own)});
  }
  return result;
}

std::vector<std::string> SoftSupport::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  std::vector<std::string> cards;
  int offset = 0;
  for (const updating::SupportDof& dof : line_of(where, setting).dofs) {
    if (!card_component(*setting.deck, dof.node, dof.component)) {
      cards.push_back(fmt::format(
          "$ grid {}: no component along its axes (CD) is the one released; "
          "give it CD 0, then a CELAS2 of {:.4g} {} on component {}",
          dof.node,
          p[0] * dof.length,
          dof.component > 3 ? "N m/rad" : "N/m",
          dof.component));
      continue;
    }
    const std::vector<std::string> spring = ground_spring_cards(
        *setting.deck, offset++, dof.node, dof.component, p[0] * dof.length);
    cards.insert(cards.end(), spring.begin(), spring.end());
  }
  return cards;
}

}  // namespace tapfit::effects
