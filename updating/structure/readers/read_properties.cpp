// PSHELL, PBAR, PBARL, PBEAM, PROD, PELAS, PDAMP, MAT1, MAT8, PARAM.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::structure {
namespace {

void refuse_negative_density(const CardReader& card, double rho) {
  if (!(rho >= 0.0)) {
    card.fail(fmt::format("RHO = {} is no density", rho),
              "Give a mass per volume of zero or more.");
  }
}

void read_mat1(DeckBuilder& builder, const CardReader& card) {
  Material m;
  m.id = card.id(1, "MID");
  builder.define(card, "material", m.id);
  m.where = card.where();
  m.E = card.real_or(2, 0.0, "E");
  m.G = card.real_or(3, 0.0, "G");
  m.nu = card.real_or(4, 0.0, "NU");
  m.rho = card.real_or(5, 0.0, "RHO");
  if (card.blank(2) && card.blank(3)) {
    card.fail("neither E nor G is given", "Give two of E, G and NU.");
  }
  if (card.blank(2)) m.E = 2.0 * m.G * (1.0 + m.nu);
  if (card.blank(3)) m.G = m.E / (2.0 * (1.0 + m.nu));
  if (card.blank(4) && !card.blank(2) && !card.blank(3) && m.G > 0.0) {
    m.nu = m.E / (2.0 * m.G) - 1.0;
  }
  if (card.blank(4) && (card.blank(2) || card.blank(3))) {
    builder.warn(card, "only one of E, G, NU is given; NU = 0 is used");
  }
  if (!(m.E >= 0.0) || m.G < 0.0 || m.nu <= -1.0 || m.nu > 0.5) {
    card.fail(
        fmt::format(
            "E = {}, G = {}, NU = {} is no elastic material", m.E, m.G, m.nu),
        "Give two of E, G and NU, positive, NU 0.5 at most.");
  }
  const double implied = m.E / (2.0 * (1.0 + m.nu));
  if (std::abs(m.G - implied) > 0.01 * m.G) {
    builder.warn(card,
                 fmt::format("E, G and NU do not agree, E / (2 (1 + NU)) is "
                             "{:.4g}: shear and twist go with G, all else with "
                             "E and NU",
                             implied));
  }
  if (m.nu < 0.0) {
    builder.warn(card, fmt::format("NU = {:.4g} is unusual", m.nu));
  }
  refuse_negative_density(card, m.rho);
  builder.deck.materials[m.id] = m;
}

void read_mat8(DeckBuilder& builder, const CardReader& card) {
  Material m;
  m.id = card.id(1, "MID");
  builder.define(card, "material", m.id);
  m.where = card.where();
  m.orthotropic = true;
  m.E = card.real(2, "E1");
  m.E2 = card.real(3, "E2");
  m.nu = card.real_or(4, 0.0, "NU12");
  m.G = card.real(5, "G12");
  m.G1z = card.real_or(6, 0.0, "G1Z");
  m.G2z = card.real_or(7, 0.0, "G2Z");
  m.rho = card.real_or(8, 0.0, "RHO");
  if (m.E <= 0.0 || m.E2 <= 0.0 || m.G <= 0.0 || m.nu * m.nu * m.E2 >= m.E) {
    card.fail(
        fmt::format(
            "E1 = {}, E2 = {}, NU12 = {}, G12 = {} is no elastic material",
            m.E,
            m.E2,
            m.nu,
            m.G),
        "E1, E2 and G12 must be above zero, and NU12^2 below E1/E2.");
  }
  refuse_negative_density(card, m.rho);
  builder.deck.materials[m.id] = m;
}

void read_pshell(DeckBuilder& builder, const CardReader& card) {
  ShellProperty p;
  p.id = card.id(1, "PID");
  builder.define(card, "PSHELL", p.id);
  p.where = card.where();
  p.membrane = card.integer_or(2, 0, "MID1");
  p.thickness = card.real(3, "T");
  p.bending = card.integer_or(4, 0, "MID2");
  p.bending_ratio = card.real_or(5, 1.0, "12I/T**3");
  p.shear = card.integer_or(6, 0, "MID3");
  p.shear_ratio = card.real_or(7, 5.0 / 6.0, "TS/T");
  p.nonstructural = card.real_or(8, 0.0, "NSM");
  if (p.thickness <= 0.0) {
    card.fail(fmt::format("the thickness is {}", p.thickness),
              "Give a thickness above zero.");
  }
  if (!(p.bending_ratio >= 0.0 && p.shear_ratio >= 0.0 &&
        p.nonstructural >= 0.0)) {
    card.fail("12I/T**3, TS/T or NSM is below zero",
              "Give values of zero or more.");
  }
  if (p.bending == -1) {
    builder.warn(card, "MID2 = -1 (plane strain) is taken as plane stress");
    p.bending = p.membrane;
  }
  if (card.integer_or(11, 0, "MID4") != 0) {
    builder.warn(card, "MID4 (membrane-bending coupling) is ignored");
  }
  builder.deck.shell_properties[p.id] = p;
}

void refuse_negative(const CardReader& card, double value, const char* name) {
  if (value >= 0.0) return;
  card.fail(fmt::format("{} = {} is below zero", name, value),
            "Give a section value of zero or more.");
}

void check_section(const CardReader& card, const BarProperty& p) {
  refuse_negative(card, p.area, "A");
  refuse_negative(card, p.I1, "I1");
  refuse_negative(card, p.I2, "I2");
  refuse_negative(card, p.J, "J");
  refuse_negative(card, p.K1, "K1");
  refuse_negative(card, p.K2, "K2");
  refuse_negative(card, p.nonstructural, "NSM");
  if (p.I12 * p.I12 > p.I1 * p.I2) {
    card.fail(fmt::format("I12 = {} is too large: I1 I2 - I12^2 is below zero",
                          p.I12),
              "Correct I1, I2 or I12.");
  }
}

void read_pbar(DeckBuilder& builder, const CardReader& card) {
  BarProperty p;
  p.id = card.id(1, "PID");
  builder.define(card, "PBAR, PBARL or PBEAM", p.id);
  p.where = card.where();
  p.material = card.id(2, "MID");
  p.area = card.real_or(3, 0.0, "A");
  p.I1 = card.real_or(4, 0.0, "I1");
  p.I2 = card.real_or(5, 0.0, "I2");
  p.J = card.real_or(6, 0.0, "J");
  p.nonstructural = card.real_or(7, 0.0, "NSM");
  p.K1 = card.real_or(17, 0.0, "K1");
  p.K2 = card.real_or(18, 0.0, "K2");
  p.I12 = card.real_or(19, 0.0, "I12");
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

void read_pbarl(DeckBuilder& builder, const CardReader& card) {
  const std::string type = upper(card.text(4));
  const std::size_t count = section_dimensions(type);
  if (count == 0) {
    card.fail(fmt::format("the section type \"{}\" is not supported", type),
              "Give the section's area and moments with a PBAR.");
  }
  std::vector<double> dimensions;
  for (std::size_t i = 0; i < count; ++i) {
    dimensions.push_back(card.real(9 + i, "DIM"));
  }
  std::optional<BarProperty> p = section_of(type, dimensions);
  if (!p) {
    card.fail("the dimensions give no section",
              "They must be above zero and walls must fit inside.");
  }
  p->id = card.id(1, "PID");
  builder.define(card, "PBAR, PBARL or PBEAM", p->id);
  p->where = card.where();
  p->material = card.id(2, "MID");
  p->nonstructural = card.real_or(9 + count, 0.0, "NSM");
  builder.deck.bar_properties[p->id] = *p;
}

// Skips the intermediate and end B stations, which must repeat end A.
std::size_t skip_stations(const CardReader& card) {
  std::size_t at = 9;
  const auto is_option = [&](std::size_t i) {
    const std::string word = upper(card.text(i));
    return word == "YES" || word == "YESA" || word == "NO";
  };
  if (!is_option(at)) at += 8;
  while (is_option(at)) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double here = card.real_or(3 + i, 0.0, "section");
      const double there = card.real_or(at + 2 + i, here, "section");
      if (std::abs(here - there) > 1e-9 * std::abs(here)) {
        card.fail("the section changes along the beam",
                  "Only constant sections are supported; split the beam.");
      }
    }
    at += upper(card.text(at)) == "YES" ? 16 : 8;
  }
  return at;
}

void read_pbeam(DeckBuilder& builder, const CardReader& card) {
  BarProperty p;
  p.id = card.id(1, "PID");
  builder.define(card, "PBAR, PBARL or PBEAM", p.id);
  p.where = card.where();
  p.material = card.id(2, "MID");
  p.area = card.real(3, "A(A)");
  p.I1 = card.real(4, "I1(A)");
  p.I2 = card.real(5, "I2(A)");
  p.I12 = card.real_or(6, 0.0, "I12(A)");
  p.J = card.real_or(7, 0.0, "J(A)");
  p.nonstructural = card.real_or(8, 0.0, "NSM(A)");
  const std::size_t shear = skip_stations(card);
  p.K1 = card.real_or(shear, 1.0, "K1");
  p.K2 = card.real_or(shear + 1, 1.0, "K2");
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

void read_prod(DeckBuilder& builder, const CardReader& card) {
  RodProperty p;
  p.id = card.id(1, "PID");
  builder.define(card, "PROD", p.id);
  p.where = card.where();
  p.material = card.id(2, "MID");
  p.area = card.real_or(3, 0.0, "A");
  p.J = card.real_or(4, 0.0, "J");
  p.nonstructural = card.real_or(6, 0.0, "NSM");
  for (const double value : {p.area, p.J, p.nonstructural}) {
    refuse_negative(card, value, "A, J or NSM");
  }
  builder.deck.rod_properties[p.id] = p;
}

void read_pelas(DeckBuilder& builder, const CardReader& card) {
  for (std::size_t at : {std::size_t{1}, std::size_t{5}}) {
    if (card.blank(at)) continue;
    const int id = card.id(at, "PID");
    builder.define(card, "PELAS", id);
    builder.spring_properties[id] = {card.real(at + 1, "K"),
                                     card.real_or(at + 2, 0.0, "GE")};
  }
}

void read_pdamp(DeckBuilder& builder, const CardReader& card) {
  for (std::size_t at = 1; at < 9; at += 2) {
    if (card.blank(at)) continue;
    const int id = card.id(at, "PID");
    builder.define(card, "PDAMP", id);
    builder.damper_properties[id] = card.real(at + 1, "B");
  }
}

void read_param(DeckBuilder& builder, const CardReader& card) {
  const std::string name = upper(card.text(1));
  if (name == "COUPMASS") {
    builder.deck.coupled_mass = card.integer(2, "COUPMASS") > 0;
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
  return {{"MAT1", read_mat1},
          {"MAT8", read_mat8},
          {"PSHELL", read_pshell},
          {"PBAR", read_pbar},
          {"PBARL", read_pbarl},
          {"PBEAM", read_pbeam},
          {"PROD", read_prod},
          {"PELAS", read_pelas},
          {"PDAMP", read_pdamp},
          {"PBUSH", read_pbush},
          {"PARAM", read_param}};
}

}  // namespace tapfit::structure
