#include "updating/effects/joint.hpp"

#include "updating/effects/joint_cards.hpp"
#include "updating/places/joint_line.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::effects {
namespace {

double length_of(const Where& where, const Setting& setting) {
  if (where.nodes.size() < 2) return 1.0;
  return updating::shell_joint(*setting.deck, where.nodes).length;
}

}  // namespace

std::vector<Where> Joint::places(const Setting& setting) const {
  std::vector<Where> result;
  if (setting.deck == nullptr) return result;
  for (const updating::JointPlace& place :
       updating::joint_places(*setting.deck)) {
    Where where;
    where.nodes = place.nodes;
    if (place.bar != 0) where.elements = {place.bar};
    result.push_back(where);
  }
  return result;
}

std::vector<ParameterSpec> Joint::parameters(const Where& where,
                                             const Setting& setting) const {
  // As for a soft support; the base narrows it to what shows.
  const double length = length_of(where, setting);
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double high = 2.0 * std::numbers::pi * setting.high_hz;
  const double lower = 1e-3 * setting.mass_kg * low * low / length;
  const double upper = 1e3 * setting.mass_kg * high * high / length;
  return {{"rotational_stiffness_nm_per_rad_per_m",
           std::sqrt(lower * upper),
           lower,
           upper}};
}

std::vector<Effect::Derived> Joint::derived(const Where& where,
                                            const Setting& setting) const {
  return {{"rotational_stiffness_nm_per_rad", {length_of(where, setting)}}};
}

std::vector<std::string> Joint::bulk_data(const Where& where,
                                          const Setting& setting,
                                          const std::vector<double>& p) const {
  const updating::JointLine line = joint_at(where, setting);
  return joint_cards(*setting.deck, line, p[0]).added;
}

}  // namespace tapfit::effects
