#include "updating/structure/edit/deck_cards.hpp"

#include "acquisition/foundation/dof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

// Cosine between a grid's own axis and a basic one.
double cosine(const Deck& deck, int node, int own, int basic) {
  return deck.grid(node).axes((basic - 1) % 3, own % 3);
}

std::string grid_card_at(const Deck& deck,
                         int id,
                         const Eigen::Vector3d& position,
                         const std::string& held,
                         int axes) {
  const Eigen::Vector3d at = position / deck.file_length_m;
  return fmt::format("GRID,{},0,{},{},{},{},{}",
                     id,
                     card_real(at.x()),
                     card_real(at.y()),
                     card_real(at.z()),
                     axes,
                     held.empty() ? "0" : held);
}

std::string arm_card(const Deck& deck, int offset, int node, int grid) {
  return fmt::format(
      "RBE2,{},{},123456,{}", free_element(deck, offset), node, grid);
}

// Where a card takes hold, after the cards that this needs.
struct Hold {
  int node = 0;
  int component = 0;
  std::vector<std::string> cards;
};

// Between two grids the sense counts, against ground it does not.
enum class Sense { Either, Same };

Hold hold_of(
    const Deck& deck, int offset, int node, int component, Sense sense) {
  const auto own = card_component(deck, node, component);
  const bool good = own && (sense == Sense::Either ||
                            cosine(deck, node, *own - 1, component) > 0.0);
  if (good) return {node, *own, {}};
  const int grid = free_grid(deck, offset);
  return {
      grid,
      component,
      {grid_card(deck, grid, node, ""), arm_card(deck, offset, node, grid)}};
}

std::vector<std::string> ground_cards(const char* card,
                                      const Deck& deck,
                                      int offset,
                                      const Dof& dof,
                                      double size) {
  Hold hold = hold_of(deck, offset, dof.node, dof.component, Sense::Either);
  hold.cards.push_back(fmt::format(
      "{},{},{},{},{}",
      card,
      free_element(deck, offset + static_cast<int>(hold.cards.size())),
      card_real(file_stiffness(deck, dof.component, size)),
      hold.node,
      hold.component));
  return std::move(hold.cards);
}

}  // namespace

int free_element(const Deck& deck, int offset) {
  int highest = 0;
  const auto scan = [&highest](const auto& elements) {
    for (const auto& element : elements) {
      highest = std::max(highest, element.id);
    }
  };
  scan(deck.shells);
  scan(deck.bars);
  scan(deck.rods);
  scan(deck.solids);
  scan(deck.masses);
  scan(deck.scalars);
  scan(deck.bushes);
  scan(deck.rigids);
  return highest + 1 + offset;
}

double file_stiffness(const Deck& deck, int component, double si) {
  const double length = component > 3 ? deck.file_length_m : 1.0;
  return si / (deck.file_mass_kg * length * length);
}

std::string card_real(double value) { return fmt::format("{:#.7g}", value); }

int free_grid(const Deck& deck, int offset) {
  int highest = 0;
  for (const Grid& grid : deck.grids) {
    highest = std::max(highest, grid.id);
  }
  return highest + 1 + offset;
}

std::string grid_card(
    const Deck& deck, int id, int like, const std::string& held, int axes) {
  return grid_card_at(deck, id, deck.grid(like).position, held, axes);
}

std::vector<std::string> grid_on_arm(const Deck& deck,
                                     int node,
                                     const Eigen::Vector3d& at) {
  const int grid = free_grid(deck, 0);
  return {grid_card_at(deck, grid, at, "", 0), arm_card(deck, 0, node, grid)};
}

std::optional<int> card_component(const Deck& deck, int node, int component) {
  constexpr double relative_rounding = 1e-6;
  const int kind = component > 3 ? 3 : 0;
  for (int own = 0; own < 3; ++own) {
    if (std::abs(cosine(deck, node, own, component)) >
        1.0 - relative_rounding) {
      return kind + own + 1;
    }
  }
  return std::nullopt;
}

std::string point_mass_card(const Deck& deck,
                            int offset,
                            int node,
                            double mass_kg,
                            double inertia_kg_m2) {
  const double unit = deck.file_mass_kg * deck.weight_to_mass;
  std::string card = fmt::format("CONM2,{},{},,{}",
                                 free_element(deck, offset),
                                 node,
                                 card_real(mass_kg / unit));
  if (inertia_kg_m2 > 0.0) {
    const double length = deck.file_length_m;
    const std::string own = card_real(inertia_kg_m2 / (unit * length * length));
    // I11, I21, I22, I31, I32, I33 on the second line.
    card += fmt::format(",,,,,+\n+,{},,{},,,{}", own, own, own);
  }
  return card;
}

std::vector<std::string> ground_spring_cards(
    const Deck& deck, int offset, int node, int component, double stiffness) {
  return ground_cards("CELAS2", deck, offset, {node, component, 1}, stiffness);
}

// [0 k; k 0] = -k [1 -1; -1 1] + k [1 0; 0 1]
std::vector<std::string> coupling_spring_cards(const Deck& deck,
                                               int offset,
                                               int node,
                                               std::array<int, 2> components,
                                               double stiffness) {
  const double k = std::copysign(
      std::sqrt(file_stiffness(deck, components[0], std::abs(stiffness)) *
                file_stiffness(deck, components[1], std::abs(stiffness))),
      stiffness);
  std::vector<std::string> cards = {fmt::format("CELAS2,{},{},{},{},{},{}",
                                                free_element(deck, offset),
                                                card_real(-k),
                                                node,
                                                components[0],
                                                node,
                                                components[1])};
  for (const int component : components) {
    cards.push_back(fmt::format("CELAS2,{},{},{},{}",
                                free_element(deck, ++offset),
                                card_real(k),
                                node,
                                component));
  }
  return cards;
}

std::vector<std::string> ground_damper_cards(
    const Deck& deck, int offset, int node, int component, double damping) {
  return ground_cards("CDAMP2", deck, offset, {node, component, 1}, damping);
}

std::vector<std::string> absorber_cards(const Deck& deck,
                                        int node,
                                        int component,
                                        double mass_kg,
                                        double stiffness,
                                        double damping) {
  std::string held = "123456";
  held.erase(static_cast<std::size_t>(component - 1), 1);
  Hold hold = hold_of(deck, 3, node, component, Sense::Same);
  const int own = free_grid(deck, 0);
  std::vector<std::string> cards = std::move(hold.cards);
  cards.push_back(grid_card(deck, own, node, held));
  cards.push_back(point_mass_card(deck, 0, own, mass_kg));
  const auto link = [&](const char* card, int offset, double size) {
    cards.push_back(
        fmt::format("{},{},{},{},{},{},{}",
                    card,
                    free_element(deck, offset),
                    card_real(file_stiffness(deck, component, size)),
                    hold.node,
                    hold.component,
                    own,
                    component));
  };
  link("CELAS2", 1, stiffness);
  link("CDAMP2", 2, damping);
  return cards;
}

}  // namespace tapfit::structure
