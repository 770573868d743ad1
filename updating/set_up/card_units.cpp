#include "updating/set_up/card_units.hpp"

#include "updating/structure/checks/unit_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::Deck;

// A unit that is taken for the one of SI.
struct Unit {
  const char* name;
  double in_si;
};

constexpr double psi = 6894.757293168;
constexpr std::array<Unit, 4> pressure_units{
    {{"MPa", 1e6}, {"GPa", 1e9}, {"psi", psi}, {"ksi", 1e3 * psi}}};
constexpr std::array<Unit, 4> density_units{{{"g/cm3", 1e3},
                                             {"kg/mm3", 1e9},
                                             {"t/mm3", 1e12},
                                             {"lb/in3", 27679.904710191}}};
constexpr std::array<Unit, 3> length_units{
    {{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}}};

std::string kind_of(const char* number, const Unit& unit) {
  return fmt::format("{}-in-{}", number, unit.name);
}

// A number of a card: a length to some power.
struct Number {
  const char* property;
  double value;
  int power;
};

struct Section {
  const char* card;
  std::string where;
  std::vector<Number> numbers;
  bool shell = false;
};

std::map<int, Section> sections_of(const Deck& deck) {
  std::map<int, Section> result;
  for (const auto& [id, p] : deck.shell_properties) {
    if (!p.plies.empty()) continue;
    result[id] = {"PSHELL", p.where, {{"t", p.thickness, 1}}, true};
  }
  for (const auto& [id, p] : deck.bar_properties) {
    result[id] = {
        "PBAR",
        p.where,
        {{"A", p.area, 2}, {"I1", p.I1, 4}, {"I2", p.I2, 4}, {"J", p.J, 4}}};
  }
  for (const auto& [id, p] : deck.rod_properties) {
    result[id] = {"PROD", p.where, {{"A", p.area, 2}, {"J", p.J, 4}}};
  }
  return result;
}

bool is_too_long(const Number& number, double size, double unit = 1.0) {
  const double side = std::pow(std::abs(number.value), 1.0 / number.power);
  return structure::is_too_long(side * unit, size);
}

// The cards of one mistake, which are put right together.
struct Mistaken {
  std::vector<std::string> cards;
  std::vector<ScaledNumber> numbers;
};

void take(const Deck& deck,
          const char* number,
          const Unit& unit,
          Mistaken all,
          std::vector<CardSlip>& slips) {
  if (all.numbers.empty()) return;
  slips.push_back(slip_of(deck,
                          fmt::format("{}, {} from {} to SI",
                                      fmt::join(all.cards, ", "),
                                      number,
                                      unit.name),
                          kind_of(number, unit),
                          std::move(all.numbers)));
  slips.back().from_other_unit = true;
}

void add_materials(const Deck& deck, std::vector<CardSlip>& slips) {
  const auto add = [&](const char* number,
                       const char* property,
                       const Unit& unit,
                       double E_in_si,
                       double rho_in_si) {
    Mistaken all;
    for (const auto& [id, m] : deck.materials) {
      const double rho = m.rho * deck.weight_to_mass;
      if (m.E <= 0.0 || structure::is_solid(m.E, rho)) continue;
      if (!structure::is_solid(m.E * E_in_si, rho * rho_in_si)) continue;
      all.cards.push_back(card_name(m.where, fmt::format("material {}", id)));
      all.numbers.push_back(
          scaled_number("material", id, property, unit.in_si));
    }
    take(deck, number, unit, std::move(all), slips);
  };
  for (const Unit& unit : pressure_units) add("E", "E", unit, unit.in_si, 1.0);
  for (const Unit& unit : density_units)
    add("RHO", "rho", unit, 1.0, unit.in_si);
}

void add_sections(const Deck& deck, std::vector<CardSlip>& slips) {
  const double size = structure::size_of(deck);
  const std::map<int, Section> sections = sections_of(deck);
  const auto add = [&](const char* number, bool shells, const Unit& unit) {
    Mistaken all;
    for (const auto& [id, section] : sections) {
      if (section.shell != shells) continue;
      const std::size_t before = all.numbers.size();
      for (const Number& n : section.numbers) {
        if (!is_too_long(n, size) || is_too_long(n, size, unit.in_si)) continue;
        all.numbers.push_back(scaled_number(
            "property", id, n.property, std::pow(unit.in_si, n.power)));
      }
      if (all.numbers.size() == before) continue;
      all.cards.push_back(
          card_name(section.where, fmt::format("{} {}", section.card, id)));
    }
    take(deck, number, unit, std::move(all), slips);
  };
  for (const Unit& unit : length_units) {
    add("T", true, unit);
    add("section", false, unit);
  }
}

}  // namespace

const std::vector<std::string>& unit_slip_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all;
    for (const Unit& unit : pressure_units) all.push_back(kind_of("E", unit));
    for (const Unit& unit : density_units) all.push_back(kind_of("RHO", unit));
    for (const char* number : {"T", "section"}) {
      for (const Unit& unit : length_units)
        all.push_back(kind_of(number, unit));
    }
    return all;
  }();
  return kinds;
}

std::vector<CardSlip> unit_slips_of(const Deck& deck) {
  std::vector<CardSlip> slips;
  if (deck.given) return slips;
  add_materials(deck, slips);
  add_sections(deck, slips);
  return slips;
}

}  // namespace tapfit::updating
