// PSHELL, PSHEAR, PROD, PTUBE, PSOLID, PARAM. Sections of bars, laminates,
// materials and springs have files of their own.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

void refuse_no_thickness(const CardReader& card, double thickness) {
  if (thickness > 0.0) return;
  card.fail(fmt::format("the thickness is {}", thickness),
            "Give a thickness above zero.");
}

void read_pshell(DeckBuilder& builder, const CardReader& card) {
  auto p = defined_by<ShellProperty>(builder, card, "PSHELL");
  p.membrane = card.integer_or(2, 0, "MID1");
  // Blank where each element has its own.
  p.thickness = card.real_or(3, 0.0, "T");
  p.bending = card.integer_or(4, 0, "MID2");
  p.bending_ratio = card.real_or(5, 1.0, "12I/T**3");
  p.shear = card.integer_or(6, 0, "MID3");
  p.shear_ratio = card.real_or(7, 5.0 / 6.0, "TS/T");
  p.nonstructural = card.real_or(8, 0.0, "NSM");
  if (!card.blank(3)) refuse_no_thickness(card, p.thickness);
  if (!(p.bending_ratio >= 0.0 && p.shear_ratio >= 0.0 &&
        p.nonstructural >= 0.0)) {
    card.fail("12I/T**3, TS/T or NSM is below zero",
              "Give values of zero or more.");
  }
  if (p.bending == -1) {
    builder.warn(card, "MID2 = -1 (plane strain) is taken as plane stress");
    p.bending = p.membrane;
  }
  p.coupling = card.integer_or(11, 0, "MID4");
  builder.deck.shell_properties[p.id] = p;
}

void refuse_negative(const CardReader& card, double value, const char* name) {
  if (value >= 0.0) return;
  card.fail(fmt::format("{} = {} is below zero", name, value),
            "Give a section value of zero or more.");
}

void read_prod(DeckBuilder& builder, const CardReader& card) {
  auto p = defined_by<RodProperty>(builder, card, "PROD");
  p.material = card.id(2, "MID");
  p.area = card.real_or(3, 0.0, "A");
  p.J = card.real_or(4, 0.0, "J");
  p.nonstructural = card.real_or(6, 0.0, "NSM");
  for (const double value : {p.area, p.J, p.nonstructural}) {
    refuse_negative(card, value, "A, J or NSM");
  }
  builder.deck.rod_properties[p.id] = p;
}

// OD, T, NSM; the mean diameter where OD2 differs.
void read_ptube(DeckBuilder& builder, const CardReader& card) {
  auto p = defined_by<RodProperty>(builder, card, "PROD");
  p.material = card.id(2, "MID");
  const double first = card.real(3, "OD");
  const double outer = 0.5 * (first + card.real_or(7, first, "OD2"));
  const double t = card.real_or(4, 0.0, "T");
  if (!(outer > 0.0 && t >= 0.0 && 2.0 * t <= outer)) {
    card.fail(fmt::format("OD = {} and T = {} give no tube", outer, t),
              "Give a diameter above zero and a wall of half of it at most.");
  }
  const double inner = t == 0.0 ? 0.0 : outer - 2.0 * t;
  p.area = std::numbers::pi / 4.0 * (outer * outer - inner * inner);
  p.J = std::numbers::pi / 32.0 * (std::pow(outer, 4) - std::pow(inner, 4));
  p.nonstructural = card.real_or(5, 0.0, "NSM");
  refuse_negative(card, p.nonstructural, "NSM");
  builder.deck.rod_properties[p.id] = p;
}

void read_pshear(DeckBuilder& builder, const CardReader& card) {
  auto p = defined_by<ShellProperty>(builder, card, "PSHELL");
  p.panel = true;
  p.membrane = card.id(2, "MID");
  p.thickness = card.real(3, "T");
  refuse_no_thickness(card, p.thickness);
  p.nonstructural = card.real_or(4, 0.0, "NSM");
  p.extensional = {card.real_or(5, 0.0, "F1"), card.real_or(6, 0.0, "F2")};
  for (const double value :
       {p.nonstructural, p.extensional[0], p.extensional[1]}) {
    refuse_negative(card, value, "NSM, F1 or F2");
  }
  builder.deck.shell_properties[p.id] = p;
}

void read_psolid(DeckBuilder& builder, const CardReader& card) {
  auto p = defined_by<SolidProperty>(builder, card, "PSOLID");
  p.material = card.id(2, "MID");
  const int system = card.integer_or(3, 0, "CORDM");
  p.in_element = system < 0;
  if (system > 0) p.axes = builder.system(card, system).axes;
  const std::string function = upper(card.text(7));
  if (!function.empty() && function != "SMECH") {
    card.fail(fmt::format("a fluid ({}) is not supported", function),
              "Take its elements out of the model, or use SMECH.");
  }
  builder.deck.solid_properties[p.id] = p;
}

// A number above zero, or YES as OptiStruct has it.
bool is_on(const CardReader& card, const char* name) {
  const std::string word = upper(card.text(2));
  if (word == "YES" || word == "NO") return word == "YES";
  return card.integer(2, name) > 0;
}

void read_param(DeckBuilder& builder, const CardReader& card) {
  const std::string name = upper(card.text(1));
  if (name == "COUPMASS") {
    builder.deck.coupled_mass = is_on(card, "COUPMASS");
  } else if (name == "WTMASS") {
    builder.deck.weight_to_mass = card.real(2, "WTMASS");
    if (builder.deck.weight_to_mass <= 0.0) {
      card.fail("WTMASS is not above zero", "Correct or remove the PARAM.");
    }
  } else if (name == "G") {
    builder.deck.structural_damping = card.real(2, "G");
  }
}

}  // namespace

CardTable property_cards() {
  return {{"PSHELL", read_pshell},
          {"PSHEAR", read_pshear},
          {"PROD", read_prod},
          {"PTUBE", read_ptube},
          {"PSOLID", read_psolid},
          {"PARAM", read_param}};
}

}  // namespace tapfit::structure
