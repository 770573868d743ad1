#include "updating/structure/deck/deck.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
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

std::vector<int> with_mids(std::vector<int> grids,
                           const std::vector<int>& mids) {
  std::copy_if(mids.begin(), mids.end(), std::back_inserter(grids), [](int id) {
    return id != 0;
  });
  return grids;
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

// A layer's material, which says nothing of a bar's axis or a solid.
template <typename Property>
void refuse_layered(const Deck& deck,
                    const Property& property,
                    const char* kind) {
  const auto found = deck.materials.find(property.material);
  if (found == deck.materials.end()) return;
  const Material& m = found->second;
  if (!m.orthotropic && !m.is_plane()) return;
  throw InputError(
      fmt::format("material {} is a {}, which is for shells",
                  property.material,
                  m.orthotropic ? "MAT8" : "MAT2"),
      card_place(deck,
                 property.where,
                 fmt::format("{} {}", kind, std::abs(property.id))),
      "Name a MAT1.");
}

void check_properties(const Deck& deck) {
  for (const auto& [id, p] : deck.shell_properties) {
    check_materials(
        deck, p, {p.membrane, p.bending, p.shear, p.coupling}, "PSHELL");
    for (const Ply& ply : p.plies) {
      check_materials(deck, p, {ply.material}, "PCOMP");
    }
  }
  for (const auto& [id, p] : deck.solid_properties) {
    check_materials(deck, p, {p.material}, "PSOLID");
    refuse_layered(deck, p, "PSOLID");
  }
  for (const auto& [id, p] : deck.bar_properties) {
    check_materials(deck, p, {p.material}, "PBAR");
    refuse_layered(deck, p, "PBAR");
  }
  for (const auto& [id, p] : deck.rod_properties) {
    const char* kind = id < 0 ? "CONROD" : "PROD";
    check_materials(deck, p, {p.material}, kind);
    refuse_layered(deck, p, kind);
  }
}

template <typename Element>
std::vector<int> grids_of(const Element& element) {
  if constexpr (requires { element.mids; }) {
    return element.all_grids();
  } else {
    return {element.grids.begin(), element.grids.end()};
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
  for (const int grid : grids_of(element)) {
    if (!deck.has_grid(grid)) missing(fmt::format("grid {}", grid), place());
  }
  if (!properties.contains(element.property)) {
    missing(fmt::format("{} {}", property, element.property), place());
  }
}

}  // namespace

std::size_t Deck::element_count() const {
  return shells.size() + bars.size() + rods.size() + masses.size() +
         scalars.size() + bushes.size() + rigids.size() + solids.size() +
         relations.size() - 6 * measuring.size();
}

std::vector<int> Shell::all_grids() const { return with_mids(grids, mids); }
std::vector<int> Solid::all_grids() const { return with_mids(grids, mids); }

std::vector<Eigen::Vector3d> Deck::positions(std::span<const int> ids) const {
  std::vector<Eigen::Vector3d> at;
  for (const int id : ids) at.push_back(grid(id).position);
  return at;
}

Eigen::MatrixX3d Deck::position_rows(std::span<const int> ids) const {
  Eigen::MatrixX3d X(std::ssize(ids), 3);
  for (Eigen::Index i = 0; i < X.rows(); ++i) {
    X.row(i) = grid(ids[static_cast<std::size_t>(i)]).position.transpose();
  }
  return X;
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
  for (const Solid& e : deck.solids) {
    check_element(deck, e, deck.solid_properties, "solid", "PSOLID");
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
  for (const Relation& e : deck.relations) {
    need(e.grid, e.where, "MPC");
    for (const RelationTerm& term : e.terms) need(term.grid, e.where, "MPC");
  }
  for (const Constraint& held : deck.constraints) need(held.grid, {}, "SPC");
}

}  // namespace tapfit::structure
