#include "updating/properties/line_mass.hpp"

#include "updating/structure/mesh/corner_mass.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

bool has_mass(const structure::Deck& deck, const structure::Bar& bar) {
  const auto section = deck.bar_properties.find(bar.property);
  if (section == deck.bar_properties.end()) return false;
  const structure::BarProperty& p = section->second;
  const auto material = deck.materials.find(p.material);
  return material != deck.materials.end() && material->second.rho > 0.0 &&
         p.I1 + p.I2 > 0.0;
}

}  // namespace

bool has_line_mass(const structure::Deck& deck) {
  const bool on_lines =
      std::ranges::any_of(deck.bars, [&](const structure::Bar& bar) {
        return !bar.rotary_inertia && has_mass(deck, bar);
      });
  return on_lines || !structure::misplaced_mass(deck).empty();
}

structure::Deck without_line_mass(structure::Deck deck) {
  deck = structure::with_placed_mass(std::move(deck));
  for (structure::Bar& bar : deck.bars) bar.rotary_inertia = true;
  return deck;
}

}  // namespace tapfit::updating
