#include "updating/effects/joint.hpp"

#include "updating/effects/joint_cards.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/places/joint_line.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::effects {
namespace {

double length_of(const Where& where, const Setting& setting) {
  if (where.nodes.size() < 2) return 1.0;
  return updating::shell_joint(*setting.deck, where.nodes).length;
}

// Second moment of a crack's face [m^4].
double turn_of(const Where& where, const Setting& setting) {
  double turn = 0.0;
  for (const updating::PartedGrid& grid :
       updating::crack_line(*setting.deck, where.nodes).grids) {
    turn += grid.turn;
  }
  return turn;
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

bool Joint::takes(const std::string& form,
                  const Where& place,
                  const Setting& setting) const {
  return form == updating::crack && setting.deck != nullptr &&
         !updating::crack_line(*setting.deck, place.nodes).grids.empty();
}

std::vector<ParameterSpec> Joint::parameters(const Where& where,
                                             const Setting& setting) const {
  // As for a soft support; the base narrows it to what shows.
  const bool is_crack = where.variant == updating::crack;
  const double length =
      is_crack ? turn_of(where, setting) : length_of(where, setting);
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double high = 2.0 * std::numbers::pi * setting.high_hz;
  const double lower = 1e-3 * setting.mass_kg * low * low / length;
  const double upper = 1e3 * setting.mass_kg * high * high / length;
  return {{is_crack ? "bed_stiffness_n_per_m3"
                    : "rotational_stiffness_nm_per_rad_per_m",
           std::sqrt(lower * upper),
           lower,
           upper}};
}

std::vector<Effect::Derived> Joint::derived(const Where& where,
                                            const Setting& setting) const {
  // Of a crack the faces' stiffness is all there is to tell.
  if (where.variant == updating::crack) return {};
  return {{"rotational_stiffness_nm_per_rad", {length_of(where, setting)}}};
}

std::vector<std::string> Joint::bulk_data(const Where& where,
                                          const Setting& setting,
                                          const std::vector<double>& p) const {
  return joint_cards(where, setting, p[0]).added;
}

}  // namespace tapfit::effects
