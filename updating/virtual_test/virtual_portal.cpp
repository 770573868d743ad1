#include "updating/virtual_test/virtual_portal.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

constexpr double step = 0.05;  // length of a bar element [m]
// In steps.
constexpr int leg = 20;
constexpr int span = 14;
constexpr int overhang = 6;
constexpr int tie_height = 9;

constexpr double wide = 0.030;  // [m]
constexpr double thin = 0.015;
// Torsion of a rectangle of sides 2 : 1 (S. Timoshenko, J. N. Goodier, "Theory
// of Elasticity", 3rd ed., 1970, section 109).
constexpr double torsion = 0.229;

using Place = std::pair<int, int>;  // steps along x and z

class Builder {
 public:
  Builder() {
    run({0, 0}, {0, 1}, leg);
    run({span, 0}, {0, 1}, leg);
    run({0, leg}, {1, 0}, span + overhang);
    run({0, tie_height}, {1, 0}, span);
    for (const int foot : {0, span}) {
      deck_.constraints.push_back({grid_of_.at({foot, 0}), "123456"});
    }
    add_properties();
  }

  [[nodiscard]] structure::Deck deck() && { return std::move(deck_); }

 private:
  int grid(const Place& place) {
    const auto [it, fresh] =
        grid_of_.try_emplace(place, static_cast<int>(deck_.grids.size()) + 1);
    if (fresh) {
      deck_.grids.push_back(
          {it->second, {step * place.first, 0.0, step * place.second}});
    }
    return it->second;
  }

  void run(Place from, const Place& along, int count) {
    for (int k = 0; k < count; ++k) {
      const Place next{from.first + along.first, from.second + along.second};
      structure::Bar bar;
      bar.id = static_cast<int>(deck_.bars.size()) + 1;
      bar.property = 1;
      bar.grids = {grid(from), grid(next)};
      bar.orientation = Eigen::Vector3d::UnitY();
      deck_.bars.push_back(bar);
      from = next;
    }
  }

  void add_properties() {
    structure::Material steel;
    steel.id = 1;
    steel.E = 205e9;
    steel.nu = 0.3;
    steel.G = steel.E / (2.0 * (1.0 + steel.nu));
    steel.rho = 7850.0;
    deck_.materials[1] = steel;
    structure::BarProperty section;
    section.id = section.material = 1;
    section.area = wide * thin;
    section.I1 = wide * thin * thin * thin / 12.0;
    section.I2 = thin * wide * wide * wide / 12.0;
    section.J = torsion * wide * thin * thin * thin;
    section.K1 = section.K2 = 5.0 / 6.0;
    deck_.bar_properties[1] = section;
    deck_.coupled_mass = true;
  }

  structure::Deck deck_;
  std::map<Place, int> grid_of_;
};

}  // namespace

structure::Deck portal_deck() { return Builder().deck(); }

std::vector<std::string> portal_cards() {
  const structure::Deck deck = portal_deck();
  std::vector<std::string> cards{std::string("$ ") + portal_title,
                                 "$ Units: m, kg, s, N, Pa",
                                 "SOL 103",
                                 "CEND",
                                 "BEGIN BULK",
                                 "PARAM,COUPMASS,1"};
  for (const structure::Grid& grid : deck.grids) {
    cards.push_back(fmt::format("GRID,{},,{:.4f},0.,{:.4f}",
                                grid.id,
                                grid.position.x(),
                                grid.position.z()));
  }
  for (const structure::Bar& bar : deck.bars) {
    cards.push_back(fmt::format(
        "CBAR,{},1,{},{},0.,1.,0.", bar.id, bar.grids[0], bar.grids[1]));
  }
  const structure::BarProperty& section = deck.bar_properties.at(1);
  cards.push_back(fmt::format("PBAR,1,1,{:.5e},{:.5e},{:.5e},{:.5e}",
                              section.area,
                              section.I1,
                              section.I2,
                              section.J));
  cards.push_back("+,,,,,,,,");
  cards.push_back(fmt::format("+,{:.6f},{:.6f}", section.K1, section.K2));
  const structure::Material& steel = deck.materials.at(1);
  cards.push_back(
      fmt::format("MAT1,1,{:.4e},,{},{:.1f}", steel.E, steel.nu, steel.rho));
  for (const structure::Constraint& held : deck.constraints) {
    cards.push_back(fmt::format("SPC1,1,{},{}", held.components, held.grid));
  }
  cards.emplace_back("ENDDATA");
  return cards;
}

}  // namespace tapfit::updating
