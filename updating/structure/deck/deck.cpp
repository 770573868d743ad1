#include "updating/structure/deck/deck.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>

namespace tapfit::structure {
namespace {

// Decks are nearly always numbered 1, 2, 3 ... or ascending.
std::optional<std::size_t> find_grid(const std::vector<Grid>& grids, int id) {
  const std::size_t guess = static_cast<std::size_t>(id) - 1;
  if (id > 0 && guess < grids.size() && grids[guess].id == id) return guess;
  const auto by_id = [](const Grid& grid, int value) {
    return grid.id < value;
  };
  auto found = std::lower_bound(grids.begin(), grids.end(), id, by_id);
  if (found == grids.end() || found->id != id) {
    found = std::find_if(grids.begin(), grids.end(), [&](const Grid& grid) {
      return grid.id == id;
    });
  }
  if (found == grids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - grids.begin());
}

[[noreturn]] void missing(const std::string& what, const std::string& where) {
  throw InputError(what + " does not exist",
                   where,
                   "Add it to the model or correct the entry.");
}

// The materials that a property names, 0 for none.
template <typename Property>
void check_materials(const Deck& deck,
                     const Property& property,
                     std::initializer_list<int> materials,
                     const char* kind) {
  for (const int material : materials) {
    if (material == 0 || deck.materials.contains(material)) continue;
    missing(fmt::format("material {}", material),
            card_place(deck,
                       property.where,
                       fmt::format("{} {}", kind, std::abs(property.id))));
  }
}

// MAT8 is a layer's material: it says nothing of a bar's axis.
template <typename Property>
void refuse_orthotropic(const Deck& deck,
                        const Property& property,
                        const char* kind) {
  const auto found = deck.materials.find(property.material);
  if (found == deck.materials.end() || !found->second.orthotropic) return;
  throw InputError(
      fmt::format("material {} is a MAT8, which is for shells",
                  property.material),
      card_place(deck,
                 property.where,
                 fmt::format("{} {}", kind, std::abs(property.id))),
      "Name a MAT1.");
}

void check_properties(const Deck& deck) {
  for (const auto& [id, p] : deck.shell_properties) {
    check_materials(deck, p, {p.membrane, p.bending, p.shear}, "PSHELL");
  }
  for (const auto& [id, p] : deck.bar_properties) {
    check_materials(deck, p, {p.material}, "PBAR");
    refuse_orthotropic(deck, p, "PBAR");
  }
  for (const auto& [id, p] : deck.rod_properties) {
    const char* kind = id < 0 ? "CONROD" : "PROD";
    check_materials(deck, p, {p.material}, kind);
    refuse_orthotropic(deck, p, kind);
  }
}

template <typename Element, typename Properties>
void check_element(const Deck& deck,
                   const Element& element,
                   const Properties& properties,
                   const char* kind,
                   const char* property) {
  const auto place = [&] {
    return card_place(
        deck, element.where, fmt::format("{} {}", kind, element.id));
  };
  for (const int grid : element.grids) {
    if (!deck.has_grid(grid)) missing(fmt::format("grid {}", grid), place());
  }
  if (!properties.contains(element.property)) {
    missing(fmt::format("{} {}", property, element.property), place());
  }
}

}  // namespace

std::size_t Deck::element_count() const {
  return shells.size() + bars.size() + rods.size() + masses.size() +
         scalars.size() + bushes.size() + rigids.size();
}

std::size_t Deck::grid_index(int id) const {
  const std::optional<std::size_t> index = find_grid(grids, id);
  if (!index) {
    throw InputError(fmt::format("grid {} does not exist", id),
                     path.filename().string(),
                     "Name a grid of the model.");
  }
  return *index;
}

bool Deck::has_grid(int id) const { return find_grid(grids, id).has_value(); }

std::string card_place(const Deck& deck,
                       const std::string& where,
                       const std::string& name) {
  if (!where.empty()) return where;
  return fmt::format("{}: {}", deck.path.filename().string(), name);
}

void check_references(const Deck& deck) {
  check_properties(deck);
  for (const Shell& e : deck.shells) {
    check_element(deck, e, deck.shell_properties, "shell", "PSHELL");
  }
  for (const Bar& e : deck.bars) {
    check_element(deck, e, deck.bar_properties, "bar", "PBAR");
  }
  for (const Rod& e : deck.rods) {
    check_element(deck, e, deck.rod_properties, "rod", "PROD");
  }
  const auto need =
      [&](int grid, const std::string& where, const std::string& name) {
        if (!deck.has_grid(grid)) {
          missing(fmt::format("grid {}", grid), card_place(deck, where, name));
        }
      };
  for (const PointMass& e : deck.masses) {
    need(e.grid, {}, fmt::format("mass {}", e.id));
  }
  for (const RigidElement& e : deck.rigids) {
    const std::string name = fmt::format("rigid element {}", e.id);
    need(e.independent, e.where, name);
    for (const Dependent& d : e.dependents) need(d.grid, e.where, name);
  }
  for (const Constraint& held : deck.constraints) need(held.grid, {}, "SPC");
}

}  // namespace tapfit::structure
