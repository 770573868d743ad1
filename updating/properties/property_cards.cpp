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
      {"MAT2", {{"E", {2, 3, 4, 5, 6, 7}}, {"rho", {8}}}},
      {"PSHELL", {{"t", {3}}}},
      {"PSHEAR", {{"t", {3}}}},
      {"PBAR", {{"A", {3}}, {"I1", {4}}, {"I2", {5}}, {"J", {6}}}},
      {"PBEAM", {{"A", {3}}, {"I1", {4}}, {"I2", {5}}, {"J", {7}}}},
      {"PROD", {{"A", {3}}, {"J", {4}}}}};
  // Of the others a number stands in many fields, or in none.
  static const Fields none;
  const auto found = all.find(card);
  return found == all.end() ? none : found->second;
}

// The name in "file:line NAME id"; the other where nothing is said.
std::string name_in(const std::string& where, const std::string& other) {
  const std::size_t to = where.find_last_of(' ');
  if (to == std::string::npos || to == 0) return other;
  const std::size_t from = where.find_last_of(' ', to - 1);
  if (from == std::string::npos) return other;
  return where.substr(from + 1, to - from - 1);
}

std::string card_of(const structure::Deck& deck,
                    const acquisition::UncertainProperty& u) {
  if (u.card == "material") {
    const structure::Material& m = deck.materials.at(u.id);
    return name_in(m.where, m.orthotropic ? "MAT8" : "MAT1");
  }
  if (const auto p = deck.shell_properties.find(u.id);
      p != deck.shell_properties.end()) {
    return name_in(p->second.where, "PSHELL");
  }
  if (const auto p = deck.bar_properties.find(u.id);
      p != deck.bar_properties.end()) {
    return name_in(p->second.where, "PBAR");
  }
  const auto p = deck.rod_properties.find(u.id);
  return p == deck.rod_properties.end() ? "PROD"
                                        : name_in(p->second.where, "PROD");
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
