#include "updating/reduction/deck_forms.hpp"

#include "updating/properties/section_shear.hpp"
#include "updating/structure/mesh/stiff_corners.hpp"

namespace tapfit::updating {
namespace {

// From a line, past rigid to the other member's face, ln 2, to a fillet beyond
// it; below, a weld that gives.
constexpr double corner_sd = 0.7;

}  // namespace

std::vector<DeckForm> deck_forms(const structure::Deck& deck) {
  std::vector<DeckForm> forms;
  if (deck.given) return forms;
  if (const auto sections = shearless_sections(deck); !sections.empty()) {
    forms.push_back({{section_shear, section_shear_sd},
                     with_section_shear(deck, sections, 1.0)});
  }
  if (const auto inside = structure::inside_corners(deck); !inside.empty()) {
    forms.push_back({{corner_stiffness, corner_sd},
                     structure::with_stiff_corners(deck, inside)});
  }
  return forms;
}

}  // namespace tapfit::updating
