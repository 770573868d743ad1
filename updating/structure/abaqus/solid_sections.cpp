// *SOLID SECTION: PSOLID, or PROD for trusses.
#include "updating/structure/abaqus/inp_deck.hpp"

namespace tapfit::structure {
namespace {

// The system of a material that has directions; 0 for the deck's own.
int material_axes(InpDeck& deck, const Keyword& keyword) {
  const std::string name = keyword.option("ORIENTATION");
  if (name.empty()) return 0;
  const InpOrientation& o =
      named_in(deck.orientations, name, "orientation", keyword.place);
  if (is_isotropic(deck, keyword.option("MATERIAL"))) return 0;
  if (o.cylindrical) {
    keyword.fail("a cylindrical orientation of a solid is not read",
                 "Split the set into sectors with a rectangular one each.");
  }
  return write_axes(deck, o.axes(Eigen::Vector3d::Zero()), keyword.place);
}

void write_solid_section(InpDeck& deck, const Keyword& keyword) {
  const std::string name = keyword.needed_option("MATERIAL");
  const auto trusses = section_elements(deck, keyword, {InpFamily::Truss});
  const auto solids = section_elements(deck, keyword, {InpFamily::Solid});
  if (keyword.has("COMPOSITE")) {
    keyword.fail("layered solids are not read",
                 "Use an element through the thickness for each layer.");
  }
  if (!trusses.empty()) {
    const double area = number_in(keyword.line(0, "area"), 0, "area");
    const int material = material_card(deck, name, "MAT1", keyword.place);
    const int id = take_elements(deck, keyword, trusses, "PROD");
    deck.cards.card(keyword.place, "PROD", {id, material, area});
  }
  if (!solids.empty() || trusses.empty()) {
    const int material = material_card(deck, name, "MAT9", keyword.place);
    const int system = material_axes(deck, keyword);
    const int id = take_elements(deck, keyword, solids, "PSOLID");
    deck.cards.card(keyword.place, "PSOLID", {id, material, system});
  }
}

}  // namespace

void write_solid_sections(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("SOLIDSECTION")) {
    write_solid_section(deck, *keyword);
  }
}

}  // namespace tapfit::structure
