#include "updating/structure/edit/weaken_cards.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/deck/bar_thickness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tapfit::structure {
namespace {

// Positions of the MSC Nastran Quick Reference Guide, the name at 0.
const std::map<std::string, std::vector<std::size_t>> material_fields = {
    {"PSHELL", {2, 4, 6, 11}},
    {"PSHEAR", {2}},
    {"PBAR", {2}},
    {"PBARL", {2}},
    {"PBEAM", {2}},
    {"PBEAML", {2}},
    {"PROD", {2}},
    {"PTUBE", {2}},
    {"PSOLID", {2}}};
const std::map<std::string, std::vector<std::size_t>> modulus_fields = {
    {"MAT1", {2, 3}},
    {"MAT2", {2, 3, 4, 5, 6, 7}},
    {"MAT8", {2, 3, 5, 6, 7}},
    {"MAT9", {2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
              13, 14, 15, 16, 17, 18, 19, 20, 21, 22}},
    {"MAT11", {2, 3, 4, 8, 9, 10}}};
const std::map<std::string, std::size_t> density_field = {
    {"MAT1", 5}, {"MAT2", 8}, {"MAT8", 8}, {"MAT9", 23}, {"MAT11", 11}};
const std::set<std::string> element_names = {"CQUAD4",
                                             "CQUADR",
                                             "CQUAD8",
                                             "CTRIA3",
                                             "CTRIAR",
                                             "CTRIA6",
                                             "CSHEAR",
                                             "CBAR",
                                             "CBEAM",
                                             "CROD",
                                             "CTUBE",
                                             "CHEXA",
                                             "CPENTA",
                                             "CPYRAM",
                                             "CTETRA"};

int id_of(const Card& card) {
  if (card.fields.size() < 2) return 0;
  return parse_integer(card.fields[1]).value_or(0);
}

// Where a property's card names materials: of a laminate each ply's.
std::vector<std::size_t> links_of(const Card& card) {
  const auto found = material_fields.find(card.name());
  if (found != material_fields.end()) return found->second;
  std::vector<std::size_t> fields;
  const bool global = card.name() == "PCOMPG";
  if (!global && card.name() != "PCOMP") return fields;
  for (std::size_t at = global ? 10 : 9; at < card.fields.size();
       at += global ? 8 : 4) {
    fields.push_back(at);
  }
  return fields;
}

std::string& field(Card& card, std::size_t at) {
  if (card.fields.size() <= at) card.fields.resize(at + 1);
  return card.fields[at];
}

// Fields of a property's card that are less where it is thinner, each with its
// share that goes with the thickness itself; the rest goes with its cube. None
// of a card that is not written thinner.
std::map<std::size_t, double> thickness_fields(const Deck& deck, int property) {
  const auto shell = deck.shell_properties.find(property);
  if (shell != deck.shell_properties.end()) {
    const ShellProperty& p = shell->second;
    if (!p.plies.empty() || p.panel) return {};
    return {{3, 1.0}};
  }
  const auto bar = deck.bar_properties.find(property);
  const bool is_pbar = bar != deck.bar_properties.end() &&
                       bar->second.where.find(" PBAR ") != std::string::npos;
  if (!is_pbar) return {};
  const auto [first, second] = bends_across(bar->second);
  return {{3, 1.0},
          {4, first ? 0.0 : 1.0},
          {5, second ? 0.0 : 1.0},
          {6, twist_by_thickness(bar->second)}};
}

std::set<int> materials_of(const Deck& deck, int property) {
  if (const auto p = deck.shell_properties.find(property);
      p != deck.shell_properties.end()) {
    std::set<int> ids = {p->second.membrane,
                         p->second.bending,
                         p->second.shear,
                         p->second.coupling};
    for (const Ply& ply : p->second.plies) ids.insert(ply.material);
    ids.erase(0);
    return ids;
  }
  if (const auto p = deck.bar_properties.find(property);
      p != deck.bar_properties.end()) {
    return {p->second.material};
  }
  if (const auto p = deck.solid_properties.find(property);
      p != deck.solid_properties.end()) {
    return {p->second.material};
  }
  const auto p = deck.rod_properties.find(property);
  return p == deck.rod_properties.end() ? std::set<int>{}
                                        : std::set<int>{p->second.material};
}

template <class Element>
void collect(const std::vector<Element>& all,
             const std::set<int>& wanted,
             std::map<int, std::set<int>>& by_property) {
  for (const Element& e : all) {
    if (wanted.contains(e.id)) by_property[e.property].insert(e.id);
  }
}

template <class Map>
int after(const Map& map, int least) {
  return map.empty() ? least : std::max(least, map.rbegin()->first + 1);
}

}  // namespace

WeakenCards::WeakenCards(const Deck& deck,
                         const std::vector<WeakElements>& weak)
    : next_property_(after(
          deck.shell_properties,
          after(deck.bar_properties,
                after(deck.rod_properties, after(deck.solid_properties, 1))))),
      next_material_(after(deck.materials, 1)) {
  for (const WeakElements& w : weak) place(deck, w);
}

void WeakenCards::place(const Deck& deck, const WeakElements& weak) {
  std::map<int, std::set<int>> by_property;
  collect(deck.shells, weak.elements, by_property);
  collect(deck.bars, weak.elements, by_property);
  collect(deck.rods, weak.elements, by_property);
  collect(deck.solids, weak.elements, by_property);
  for (const auto& [property, elements] : by_property) {
    Copy copy;
    copy.id = next_property_++;
    const auto thinner = thickness_fields(deck, property);
    if (weak.thickness < 1.0 && !thinner.empty()) {
      for (const auto& [at, share] : thinner) {
        copy.scales[at] = weak.factor + share * (weak.thickness - weak.factor);
      }
    } else {
      copy.materials = copied_materials(materials_of(deck, property), weak);
    }
    for (const int e : elements) property_of_[e] = copy.id;
    properties_[property].push_back(std::move(copy));
  }
}

std::map<int, int> WeakenCards::copied_materials(const std::set<int>& ids,
                                                 const WeakElements& weak) {
  std::map<int, int> copied;
  for (const int id : ids) {
    copied[id] = next_material_++;
    Copy copy;
    copy.id = copied[id];
    copy.factor = weak.factor;
    copy.density = weak.thickness;
    materials_[id].push_back(std::move(copy));
  }
  return copied;
}

std::optional<Card> WeakenCards::moved(const Card& card) const {
  if (!element_names.contains(card.name())) return std::nullopt;
  const auto own = property_of_.find(id_of(card));
  if (own == property_of_.end()) return std::nullopt;
  Card result = card;
  field(result, 2) = fmt::format("{}", own->second);
  return result;
}

// Copies of a property's or material's card.
std::vector<Card> WeakenCards::copies(const Card& card) const {
  std::vector<Card> result;
  const auto multiply = [](Card& copied, std::size_t at, double by) {
    const auto value = parse_real(field(copied, at));
    if (value && by != 1.0)
      field(copied, at) = fmt::format("{:.8E}", *value * by);
  };
  const std::vector<std::size_t> links = links_of(card);
  const auto moduli = modulus_fields.find(card.name());
  if (!links.empty()) {
    const auto found = properties_.find(id_of(card));
    if (found == properties_.end()) return {};
    for (const Copy& copy : found->second) {
      Card other = card;
      field(other, 1) = fmt::format("{}", copy.id);
      for (const std::size_t at : links) {
        const auto old = parse_integer(field(other, at));
        if (!old || !copy.materials.contains(*old)) continue;
        field(other, at) = fmt::format("{}", copy.materials.at(*old));
      }
      for (const auto& [at, by] : copy.scales) multiply(other, at, by);
      result.push_back(std::move(other));
    }
  } else if (moduli != modulus_fields.end()) {
    const auto found = materials_.find(id_of(card));
    if (found == materials_.end()) return {};
    for (const Copy& copy : found->second) {
      Card other = card;
      field(other, 1) = fmt::format("{}", copy.id);
      for (const std::size_t at : moduli->second) {
        multiply(other, at, copy.factor);
      }
      multiply(other, density_field.at(card.name()), copy.density);
      result.push_back(std::move(other));
    }
  }
  return result;
}

CardEdit WeakenCards::edit(const std::vector<CardScale>& scales,
                           std::vector<bool>& done) const {
  return [this, &scales, &done](
             const Card& card) -> std::optional<std::vector<Card>> {
    if (auto other = moved(card)) return std::vector{std::move(*other)};
    Card own = rescaled(card, scales, done);
    std::vector<Card> cards = copies(own);
    if (cards.empty()) return std::nullopt;
    cards.insert(cards.begin(), std::move(own));
    return cards;
  };
}

}  // namespace tapfit::structure
