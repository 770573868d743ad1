#include "updating/structure/deck.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

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

[[noreturn]] void missing(const Deck& deck,
                          const std::string& what,
                          const std::string& element) {
  throw InputError(
      what + " does not exist",
      fmt::format("{}: {}", deck.path.filename().string(), element),
      "Add it to the model or correct the entry.");
}

void check_material(const Deck& deck, int id, const std::string& property) {
  if (!deck.materials.contains(id)) {
    missing(deck, fmt::format("material {}", id), property);
  }
}

void check_properties(const Deck& deck) {
  for (const auto& [id, p] : deck.shell_properties) {
    for (const int material : {p.membrane, p.bending, p.shear}) {
      if (material != 0) {
        check_material(deck, material, fmt::format("PSHELL {}", id));
      }
    }
  }
  for (const auto& [id, p] : deck.bar_properties) {
    check_material(deck, p.material, fmt::format("PBAR {}", id));
  }
  for (const auto& [id, p] : deck.rod_properties) {
    check_material(
        deck,
        p.material,
        id < 0 ? fmt::format("CONROD {}", -id) : fmt::format("PROD {}", id));
  }
}

}  // namespace

std::size_t Deck::element_count() const {
  return shells.size() + bars.size() + rods.size() + masses.size() +
         scalars.size();
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

void check_references(const Deck& deck) {
  check_properties(deck);
  std::unordered_set<int> ids;
  for (const Grid& grid : deck.grids) ids.insert(grid.id);
  const auto need = [&](int grid, const char* kind, int element) {
    if (!ids.contains(grid)) {
      missing(deck,
              fmt::format("grid {}", grid),
              fmt::format("{} {}", kind, element));
    }
  };
  for (const Shell& e : deck.shells) {
    for (const int grid : e.grids) need(grid, "shell", e.id);
    if (!deck.shell_properties.contains(e.property)) {
      missing(deck,
              fmt::format("PSHELL {}", e.property),
              fmt::format("shell {}", e.id));
    }
  }
  for (const Bar& e : deck.bars) {
    for (const int grid : e.grids) need(grid, "bar", e.id);
    if (!deck.bar_properties.contains(e.property)) {
      missing(deck,
              fmt::format("PBAR {}", e.property),
              fmt::format("bar {}", e.id));
    }
  }
  for (const Rod& e : deck.rods) {
    for (const int grid : e.grids) need(grid, "rod", e.id);
    if (!deck.rod_properties.contains(e.property)) {
      missing(deck,
              fmt::format("PROD {}", e.property),
              fmt::format("rod {}", e.id));
    }
  }
  for (const PointMass& e : deck.masses) need(e.grid, "mass", e.id);
  for (const Constraint& held : deck.constraints) need(held.grid, "SPC", 0);
}

}  // namespace tapfit::structure
