#include "updating/reduction/deck_forms.hpp"

#include "updating/properties/section_shear.hpp"
#include "updating/structure/mesh/stiff_corners.hpp"

namespace tapfit::updating {
namespace {

// Of ln f. Every section shears, a solid one by f = 2; a thin wall by 3.5, and
// not at all, which no structure but one of a deck's own making does, are two
// standard deviations away.
constexpr double shear_mean = 0.69;
constexpr double shear_sd = 0.35;

// Half way to the other member's face is what frames are reckoned with (a rigid
// zone factor of 0.5); from the line, or a weld that gives, to the face, ln 2,
// and a fillet.
constexpr double corner_mean = 0.41;
constexpr double corner_sd = 0.25;

}  // namespace

std::vector<DeckForm> deck_forms(const structure::Deck& deck) {
  std::vector<DeckForm> forms;
  if (deck.given) return forms;
  if (const auto sections = shearless_sections(deck); !sections.empty()) {
    forms.push_back({{section_shear, shear_sd, shear_mean},
                     with_section_shear(deck, sections, 1.0)});
  }
  if (const auto inside = structure::inside_corners(deck); !inside.empty()) {
    forms.push_back({{corner_stiffness, corner_sd, corner_mean},
                     structure::with_stiff_corners(deck, inside)});
  }
  return forms;
}

}  // namespace tapfit::updating
