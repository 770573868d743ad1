#include "updating/structure/checks/weak_properties.hpp"

#include "updating/structure/cards/listed.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace tapfit::structure {
namespace {

template <typename Elements>
std::set<int> used(const Elements& elements) {
  std::set<int> ids;
  for (const auto& e : elements) ids.insert(e.property);
  return ids;
}

std::string lacks(const ShellProperty& p) {
  if (p.panel) return {};
  if (!p.plies.empty()) {
    if (p.bending_alone)
      return "LAM = BEND, the elements do not resist in plane";
    if (p.bending_ratio > 0.0) return {};
    return "LAM = MEM, the elements do not resist bending";
  }
  if (p.membrane == 0 && p.bending == 0) {
    return "neither MID1 nor MID2, the elements have no stiffness";
  }
  if (p.membrane == 0) return "no MID1, the elements do not resist in plane";
  if (p.bending == 0 || p.bending_ratio == 0.0) {
    return "no MID2 (or 12I/T**3 of zero), the elements do not resist bending";
  }
  return {};
}

std::string lacks(const BarProperty& p) {
  std::string zero;
  if (p.area == 0.0) zero += ", A";
  if (p.I1 == 0.0) zero += ", I1";
  if (p.I2 == 0.0) zero += ", I2";
  if (zero.empty()) return {};
  return fmt::format("no {}, the bars lack that stiffness", zero.substr(2));
}

std::string lacks(const RodProperty& p) {
  if (p.area != 0.0) return {};
  return "no A, the rods neither resist nor weigh";
}

// Cards by what they lack.
using Lacking = std::map<std::string, std::vector<std::string>>;

template <typename Properties>
void add(const Deck& deck,
         const Properties& properties,
         const std::set<int>& wanted,
         const char* kind,
         Lacking& lacking) {
  for (const auto& [id, p] : properties) {
    const std::string fault = lacks(p);
    if (fault.empty() || !wanted.contains(id)) continue;
    lacking[fault].push_back(
        card_place(deck, p.where, fmt::format("{} {}", kind, id)));
  }
}

}  // namespace

std::vector<std::string> weak_property_warnings(const Deck& deck) {
  Lacking lacking;
  add(deck, deck.shell_properties, used(deck.shells), "PSHELL", lacking);
  add(deck, deck.bar_properties, used(deck.bars), "PBAR", lacking);
  add(deck, deck.rod_properties, used(deck.rods), "PROD", lacking);
  std::vector<std::string> texts;
  for (const auto& [fault, cards] : lacking) {
    texts.push_back(fmt::format(
        "{}: {}; leave it so only if that is meant", listed(cards), fault));
  }
  return texts;
}

}  // namespace tapfit::structure
