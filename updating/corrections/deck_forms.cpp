#include "updating/corrections/deck_forms.hpp"

#include "updating/properties/line_mass.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/structure/mesh/stiff_corners.hpp"

namespace tapfit::updating {
namespace {

// Of ln f. Every section shears, a solid one by f = 2; a thin wall by 3.5, and
// not at all, which no structure but one of a deck's own making does, are two
// standard deviations away and the ends.
const Correction shear = {section_shear, 0.35, 0.69, 0.0, 1.25};

// Half way to the other member's face is what frames are reckoned with (a rigid
// zone factor of 0.5); from the line to the face, ln 2.
const Correction corner = {structure::corner_stiffness, 0.25, 0.41, 0.0, 0.69};

// As for shear: f = 2 is a section of one material, and none at all two
// standard deviations away.
const Correction mass = {line_mass, 0.35, 0.69, 0.0, 1.25};

}  // namespace

std::vector<DeckForm> deck_forms(const structure::Deck& deck) {
  std::vector<DeckForm> forms;
  if (deck.given) return forms;
  if (const auto sections = shearless_sections(deck); !sections.empty()) {
    forms.push_back({shear, with_section_shear(deck, sections, 1.0)});
  }
  if (const auto inside = structure::inside_corners(deck); !inside.empty()) {
    forms.push_back({corner, structure::with_stiff_corners(deck, inside)});
  }
  if (has_line_mass(deck)) {
    forms.push_back({mass, without_line_mass(deck), true});
  }
  return forms;
}

}  // namespace tapfit::updating
