#include "updating/effects/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

int free_id(const structure::Deck& deck, int offset) {
  int highest = 0;
  const auto scan = [&highest](const auto& elements) {
    for (const auto& element : elements) {
      highest = std::max(highest, element.id);
    }
  };
  scan(deck.shells);
  scan(deck.bars);
  scan(deck.rods);
  scan(deck.masses);
  scan(deck.scalars);
  scan(deck.bushes);
  return highest + 1 + offset;
}

// Force by length is mass by time squared; a rotation has a length at either
// end.
double file_stiffness(const structure::Deck& deck, int component, double si) {
  const double length = component > 3 ? deck.file_length_m : 1.0;
  return si / (deck.file_mass_kg * length * length);
}

// A real in bulk data needs a point or an exponent with one.
std::string real(double value) { return fmt::format("{:#.7g}", value); }

}  // namespace

std::string point_mass_card(const structure::Deck& deck,
                            int offset,
                            int node,
                            double mass_kg) {
  return fmt::format("CONM2,{},{},,{}",
                     free_id(deck, offset),
                     node,
                     real(mass_kg / (deck.file_mass_kg * deck.weight_to_mass)));
}

std::string ground_spring_card(const structure::Deck& deck,
                               int offset,
                               int node,
                               int component,
                               double stiffness) {
  return fmt::format("CELAS2,{},{},{},{}",
                     free_id(deck, offset),
                     real(file_stiffness(deck, component, stiffness)),
                     node,
                     component);
}

std::string ground_damper_card(const structure::Deck& deck,
                               int offset,
                               int node,
                               int component,
                               double damping) {
  return fmt::format("CDAMP2,{},{},{},{}",
                     free_id(deck, offset),
                     real(file_stiffness(deck, component, damping)),
                     node,
                     component);
}

std::vector<std::string> absorber_cards(const structure::Deck& deck,
                                        int node,
                                        int component,
                                        double mass_kg,
                                        double stiffness,
                                        double damping) {
  int own = 0;
  for (const structure::Grid& grid : deck.grids) own = std::max(own, grid.id);
  ++own;
  const Eigen::Vector3d at =
      deck.grids[deck.grid_index(node)].position / deck.file_length_m;
  std::string held = "123456";
  held.erase(static_cast<std::size_t>(component - 1), 1);
  const auto link = [&](const char* card, int offset, double size) {
    return fmt::format("{},{},{},{},{},{},{}",
                       card,
                       free_id(deck, offset),
                       real(file_stiffness(deck, component, size)),
                       node,
                       component,
                       own,
                       component);
  };
  return {fmt::format("GRID,{},,{},{},{},,{}",
                      own,
                      real(at.x()),
                      real(at.y()),
                      real(at.z()),
                      held),
          point_mass_card(deck, 0, own, mass_kg),
          link("CELAS2", 1, stiffness),
          link("CDAMP2", 2, damping)};
}

}  // namespace tapfit::effects
