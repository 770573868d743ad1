// PCOMP and PCOMPG: plies from the bottom up. Stiffness and mass are those of
// the classical laminate, see elements/shell_section.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

// Where a ply's fields are.
struct PlyFields {
  std::size_t step;      // fields from ply to ply
  std::size_t material;  // from the ply's first field on
};

// What a ply leaves blank is the one's below.
std::vector<Ply> read_plies(const CardReader& card, const PlyFields& fields) {
  std::vector<Ply> plies;
  for (std::size_t first = 9; first < card.size(); first += fields.step) {
    const std::size_t at = first + fields.material;
    if (card.blank(at) && card.blank(at + 1) && card.blank(at + 2)) continue;
    const Ply below = plies.empty() ? Ply{} : plies.back();
    Ply ply;
    ply.material = card.integer_or(at, below.material, "MID");
    ply.thickness = card.real_or(at + 1, below.thickness, "T");
    ply.theta_deg = card.real_or(at + 2, 0.0, "THETA");
    if (ply.material <= 0) {
      card.fail(fmt::format("ply {} has no material", plies.size() + 1),
                "Give its MID.");
    }
    if (!(ply.thickness > 0.0)) {
      card.fail(
          fmt::format(
              "ply {} has a thickness of {}", plies.size() + 1, ply.thickness),
          "Give a T above zero for every ply, or for the first one.");
    }
    plies.push_back(ply);
  }
  if (plies.empty()) {
    card.fail("the laminate has no plies",
              "Give material, thickness and angle of each from the second line "
              "on.");
  }
  return plies;
}

void read_laminate(DeckBuilder& builder,
                   const CardReader& card,
                   const PlyFields& fields) {
  auto p = defined_by<ShellProperty>(builder, card, "PSHELL");
  p.plies = read_plies(card, fields);
  const std::string kind = upper(card.text(8));
  if (kind == "SYM") {
    p.plies.insert(p.plies.end(), p.plies.rbegin(), p.plies.rend());
  } else if (kind == "MEM") {
    p.bending_ratio = 0.0;
  } else if (kind == "BEND") {
    p.bending_alone = true;
  } else if (kind == "SMEAR") {
    p.shear_ratio = 0.0;
  } else if (!kind.empty()) {
    card.fail(
        fmt::format("LAM = {} is not supported: the stiffness of its "
                    "plies would be another one",
                    kind),
        "Leave it blank, use SYM, MEM, BEND or SMEAR, or give the section "
        "by a PSHELL.");
  }
  for (const Ply& ply : p.plies) p.thickness += ply.thickness;
  const double middle = -0.5 * p.thickness;
  p.bottom = kind == "SMEAR" ? middle : card.real_or(2, middle, "Z0");
  p.nonstructural = card.real_or(3, 0.0, "NSM");
  if (!(p.nonstructural >= 0.0)) {
    card.fail("NSM is below zero", "Give a value of zero or more.");
  }
  builder.deck.shell_properties[p.id] = p;
}

}  // namespace

CardTable laminate_cards() {
  return {{"PCOMP",
           [](DeckBuilder& b, const CardReader& c) {
             read_laminate(b, c, {4, 0});
           }},
          {"PCOMPG", [](DeckBuilder& b, const CardReader& c) {
             read_laminate(b, c, {8, 1});
           }}};
}

}  // namespace tapfit::structure
