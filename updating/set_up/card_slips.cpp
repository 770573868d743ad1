#include "updating/set_up/card_slips.hpp"

#include "updating/set_up/card_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::Deck;

constexpr double told_by_none = 0.01;

constexpr const char* inertias = "I1-I2";
constexpr const char* moduli = "E1-E2";
constexpr const char* doubled = "T-times-2";
constexpr const char* halved = "T-by-2";

// Two numbers of a card that may have taken each other's place.
struct Exchange {
  std::string card;
  int id = 0;
  std::array<std::string, 2> names;
  std::array<double, 2> values;
};

bool differ(double a, double b) {
  return std::abs(a - b) > told_by_none * std::max(std::abs(a), std::abs(b));
}

void add_exchange(const Deck& deck,
                  const Exchange& of,
                  const std::string& card_in_deck,
                  const char* kind,
                  std::vector<CardSlip>& slips) {
  const auto& [a, b] = of.values;
  if (!differ(a, b)) return;
  slips.push_back(slip_of(
      deck,
      fmt::format(
          "{}, exchange {} and {}", card_in_deck, of.names[0], of.names[1]),
      kind,
      {scaled_number(of.card, of.id, of.names[0], b / a),
       scaled_number(of.card, of.id, of.names[1], a / b)}));
}

void add_bars(const Deck& deck, std::vector<CardSlip>& slips) {
  for (const auto& [id, bar] : deck.bar_properties) {
    if (!(bar.I1 > 0.0 && bar.I2 > 0.0)) continue;
    add_exchange(deck,
                 {"property", id, {"I1", "I2"}, {bar.I1, bar.I2}},
                 card_name(bar.where, fmt::format("PBAR {}", id)),
                 inertias,
                 slips);
  }
}

void add_orthotropic(const Deck& deck, std::vector<CardSlip>& slips) {
  for (const auto& [id, m] : deck.materials) {
    // NU12^2 < E1/E2 of what is elastic, exchanged as well.
    if (!m.orthotropic || m.nu * m.nu * m.E >= m.E2) continue;
    add_exchange(deck,
                 {"material", id, {"E1", "E2"}, {m.E, m.E2}},
                 card_name(m.where, fmt::format("MAT8 {}", id)),
                 moduli,
                 slips);
  }
}

void add_thickness(const Deck& deck, std::vector<CardSlip>& slips) {
  for (const auto& [id, shell] : deck.shell_properties) {
    if (!shell.plies.empty() || shell.thickness <= 0.0) continue;
    const std::string card =
        card_name(shell.where, fmt::format("PSHELL {}", id));
    slips.push_back(slip_of(deck,
                            card + ", T times 2",
                            doubled,
                            {scaled_number("property", id, "t", 2.0)}));
    slips.push_back(slip_of(deck,
                            card + ", T by 2",
                            halved,
                            {scaled_number("property", id, "t", 0.5)}));
  }
}

}  // namespace

const std::vector<std::string>& slip_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all = {inertias, moduli, doubled, halved};
    std::ranges::copy(unit_slip_kinds(), std::back_inserter(all));
    return all;
  }();
  return kinds;
}

std::vector<CardSlip> card_slips(const Deck& deck) {
  std::vector<CardSlip> slips = unit_slips_of(deck);
  add_bars(deck, slips);
  add_orthotropic(deck, slips);
  add_thickness(deck, slips);
  // Of cards that no element uses nothing is told.
  std::erase_if(slips,
                [](const CardSlip& slip) { return slip.elements.empty(); });
  // Not all are tried of many cards: what moves most of the structure is.
  std::ranges::stable_sort(slips, std::ranges::greater{}, [](const auto& slip) {
    return slip.elements.size();
  });
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
