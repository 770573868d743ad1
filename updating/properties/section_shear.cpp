#include "updating/properties/section_shear.hpp"

namespace tapfit::updating {

std::set<int> shearless_sections(const structure::Deck& deck) {
  std::set<int> sections;
  for (const structure::Bar& bar : deck.bars) {
    const auto found = deck.bar_properties.find(bar.property);
    if (found == deck.bar_properties.end()) continue;
    const structure::BarProperty& p = found->second;
    if (p.K1 == 0.0 && p.K2 == 0.0 && p.area > 0.0) sections.insert(p.id);
  }
  return sections;
}

double shear_coefficient(double share) {
  constexpr double solid = 5.0 / 6.0;
  return share > 0.0 ? solid / share : 0.0;
}

structure::Deck with_section_shear(structure::Deck deck,
                                   const std::set<int>& sections,
                                   double share) {
  for (const int id : sections) {
    structure::BarProperty& p = deck.bar_properties.at(id);
    p.K1 = p.K2 = shear_coefficient(share);
  }
  return deck;
}

}  // namespace tapfit::updating
