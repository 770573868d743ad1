#include "updating/properties/property_cards.hpp"

#include <map>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using Fields = std::map<std::string, std::vector<std::size_t>>;

// Positions of the MSC Nastran Quick Reference Guide, the name at 0.
const Fields& fields_of(const std::string& card) {
  static const std::map<std::string, Fields> all = {
      {"MAT1", {{"E", {2, 3}}, {"rho", {5}}}},
      {"MAT8",
       {{"E", {2, 3, 5, 6, 7}},
        {"E1", {2}},
        {"E2", {3}},
        {"nu", {4}},
        {"G12", {5}},
        {"rho", {8}}}},
      {"PSHELL", {{"t", {3}}}},
      {"PBAR", {{"A", {3}}, {"I1", {4}}, {"I2", {5}}, {"J", {6}}}},
      {"PROD", {{"A", {3}}, {"J", {4}}}}};
  return all.at(card);
}

std::string card_of(const structure::Deck& deck,
                    const acquisition::UncertainProperty& u) {
  if (u.card == "material") {
    return deck.materials.at(u.id).orthotropic ? "MAT8" : "MAT1";
  }
  if (deck.shell_properties.contains(u.id)) return "PSHELL";
  return deck.bar_properties.contains(u.id) ? "PBAR" : "PROD";
}

}  // namespace

structure::CardScale property_card(const structure::Deck& deck,
                                   const acquisition::UncertainProperty& u,
                                   double factor) {
  const std::string card = card_of(deck, u);
  const Fields& fields = fields_of(card);
  const auto at = fields.find(u.property);
  if (at == fields.end()) return {card, u.id, {}, factor};
  return {card, u.id, at->second, factor};
}

}  // namespace tapfit::updating
