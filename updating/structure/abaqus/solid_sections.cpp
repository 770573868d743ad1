// *SOLID SECTION: PSOLID, or PROD for trusses.
#include "updating/structure/abaqus/inp_deck.hpp"

namespace tapfit::structure {
namespace {

// The system of a material that has directions; 0 for the deck's own.
int material_axes(InpDeck& deck,
                  const Keyword& keyword,
                  const Eigen::Vector3d& at) {
  const std::string name = keyword.option("ORIENTATION");
  if (name.empty()) return 0;
  const InpOrientation& o =
      named_in(deck.orientations, name, "orientation", keyword.place);
  if (is_isotropic(deck, keyword.option("MATERIAL"))) return 0;
  return write_axes(deck, o.axes(at), keyword.place);
}

// Where the material's axes turn from element to element.
bool turns(const InpDeck& deck, const Keyword& keyword) {
  const std::string name = keyword.option("ORIENTATION");
  return !name.empty() && !is_isotropic(deck, keyword.option("MATERIAL")) &&
         named_in(deck.orientations, name, "orientation", keyword.place)
             .cylindrical;
}

Eigen::Vector3d middle_of(const InpDeck& deck, const InpElement& e) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int id : e.nodes) sum += deck.node(id, e.place).at;
  return sum / static_cast<double>(e.nodes.size());
}

void write_solids(InpDeck& deck,
                  const Keyword& keyword,
                  const std::vector<std::size_t>& solids,
                  const Eigen::Vector3d& at) {
  const int material =
      material_card(deck, keyword.option("MATERIAL"), "MAT9", keyword.place);
  const int system = material_axes(deck, keyword, at);
  const int id = take_elements(deck, keyword, solids, "PSOLID");
  deck.cards.card(keyword.place, "PSOLID", {id, material, system});
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
  if (!solids.empty() && turns(deck, keyword)) {
    deck.say(keyword.place.where +
             ": each element has the cylindrical axes of its middle");
    for (const std::size_t k : solids) {
      write_solids(deck, keyword, {k}, middle_of(deck, deck.elements[k]));
    }
  } else if (!solids.empty() || trusses.empty()) {
    write_solids(deck, keyword, solids, Eigen::Vector3d::Zero());
  }
}

}  // namespace

void write_solid_sections(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("SOLIDSECTION")) {
    write_solid_section(deck, *keyword);
  }
}

}  // namespace tapfit::structure
