#include "updating/set_up/card_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::Deck;

constexpr double told_by_none = 0.01;

constexpr const char* inertias = "I1-I2";
constexpr const char* moduli = "E1-E2";
constexpr const char* doubled = "T-times-2";
constexpr const char* halved = "T-by-2";

ScaledNumber scaled(const std::string& card,
                    int id,
                    const std::string& property,
                    double factor) {
  ScaledNumber result;
  result.number.card = card;
  result.number.id = id;
  result.number.property = property;
  result.factor = factor;
  return result;
}

bool differ(double a, double b) {
  return std::abs(a - b) > told_by_none * std::max(std::abs(a), std::abs(b));
}

// Elements by their property, ascending.
template <typename Element>
std::map<int, std::vector<int>> by_property(
    const std::vector<Element>& elements) {
  std::map<int, std::vector<int>> result;
  for (const Element& e : elements) result[e.property].push_back(e.id);
  for (auto& [property, ids] : result) std::ranges::sort(ids);
  return result;
}

// "PBAR 3" out of "file:line PBAR 3", or what is said in its place.
std::string card_name(const std::string& where, const std::string& other) {
  const std::size_t space = where.find(' ');
  return space == std::string::npos ? other : where.substr(space + 1);
}

bool uses(const structure::ShellProperty& property, int material) {
  return property.membrane == material || property.bending == material ||
         std::ranges::any_of(property.plies,
                             [material](const structure::Ply& ply) {
                               return ply.material == material;
                             });
}

void add_bars(const Deck& deck, std::vector<CardSlip>& slips) {
  for (const auto& [id, elements] : by_property(deck.bars)) {
    const structure::BarProperty& bar = deck.bar_properties.at(id);
    if (!(bar.I1 > 0.0 && bar.I2 > 0.0) || !differ(bar.I1, bar.I2)) continue;
    slips.push_back(
        {fmt::format("model: {}, exchange I1 and I2",
                     card_name(bar.where, fmt::format("PBAR {}", id))),
         elements,
         inertias,
         {scaled("property", id, "I1", bar.I2 / bar.I1),
          scaled("property", id, "I2", bar.I1 / bar.I2)},
         [property = id](Deck& corrected) {
           auto& own = corrected.bar_properties.at(property);
           std::swap(own.I1, own.I2);
         }});
  }
}

void add_orthotropic(const Deck& deck, std::vector<CardSlip>& slips) {
  const std::map<int, std::vector<int>> shells = by_property(deck.shells);
  for (const auto& [id, material] : deck.materials) {
    if (!material.orthotropic || !differ(material.E, material.E2)) continue;
    // NU12^2 < E1/E2 of what is elastic, exchanged as well.
    if (material.nu * material.nu * material.E >= material.E2) continue;
    std::vector<int> elements;
    for (const auto& [property, ids] : shells) {
      if (!uses(deck.shell_properties.at(property), id)) continue;
      elements.insert(elements.end(), ids.begin(), ids.end());
    }
    if (elements.empty()) continue;
    std::ranges::sort(elements);
    slips.push_back(
        {fmt::format("model: {}, exchange E1 and E2",
                     card_name(material.where, fmt::format("MAT8 {}", id))),
         std::move(elements),
         moduli,
         {scaled("material", id, "E1", material.E2 / material.E),
          scaled("material", id, "E2", material.E / material.E2)},
         [own = id](Deck& corrected) {
           auto& exchanged = corrected.materials.at(own);
           std::swap(exchanged.E, exchanged.E2);
         }});
  }
}

void add_thickness(const Deck& deck, std::vector<CardSlip>& slips) {
  for (const auto& [id, elements] : by_property(deck.shells)) {
    const structure::ShellProperty& shell = deck.shell_properties.at(id);
    if (!shell.plies.empty() || shell.thickness <= 0.0) continue;
    for (const auto& [text, kind, factor] :
         {std::tuple{"times 2", doubled, 2.0},
          std::tuple{"by 2", halved, 0.5}}) {
      slips.push_back(
          {fmt::format("model: {}, T {}",
                       card_name(shell.where, fmt::format("PSHELL {}", id)),
                       text),
           elements,
           kind,
           {scaled("property", id, "t", factor)},
           [property = id, times = factor](Deck& corrected) {
             corrected.shell_properties.at(property).thickness *= times;
           }});
    }
  }
}

}  // namespace

const std::vector<std::string>& slip_kinds() {
  static const std::vector<std::string> kinds = {
      inertias, moduli, doubled, halved};
  return kinds;
}

std::vector<CardSlip> card_slips(const Deck& deck) {
  std::vector<CardSlip> slips;
  add_bars(deck, slips);
  add_orthotropic(deck, slips);
  add_thickness(deck, slips);
  return slips;
}

std::vector<CardSlip> slips_at(const Deck& deck, const Location& where) {
  std::vector<CardSlip> slips = card_slips(deck);
  std::erase_if(slips, [&where](const CardSlip& slip) {
    return slip.kind != where.variant || slip.elements != where.elements;
  });
  return slips;
}

}  // namespace tapfit::updating
