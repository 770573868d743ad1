#include "updating/virtual_test/structure_presets.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/virtual_test/virtual_panel.hpp"
#include "updating/virtual_test/virtual_portal.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::updating {
namespace {

// @param split elements of the truth along a side of the model's
StructurePreset panel_preset(const Panel& panel, int split) {
  const PanelMesh model = mesh_panel(panel, 1);
  PanelMesh fine = mesh_panel(panel, split);
  StructurePreset preset;
  preset.title = panel.title;
  preset.cards = panel_cards(panel, model);
  preset.model = {model.deck, std::move(fine.deck), std::move(fine.children)};
  return preset;
}

StructurePreset frame() {
  StructurePreset preset = panel_preset(frame_panel(), 3);
  preset.band_hz = {1.0, 55.0};
  preset.peak_n = 15.0;
  preset.sensors = {{0.90, 0.0, 0.0}, {0.90, 0.55, 0.0}};
  return preset;
}

StructurePreset ladder() {
  StructurePreset preset = panel_preset(ladder_panel(), 3);
  preset.band_hz = {2.0, 120.0};
  preset.peak_n = 25.0;
  return preset;
}

StructurePreset plate() {
  StructurePreset preset = panel_preset(plate_panel(), 2);
  preset.band_hz = {30.0, 600.0};
  preset.peak_n = 60.0;
  return preset;
}

StructurePreset portal() {
  StructurePreset preset;
  preset.title = portal_title;
  preset.model = split_twice(portal_deck());
  preset.cards = portal_cards();
  preset.band_hz = {4.0, 220.0};
  preset.peak_n = 80.0;
  return preset;
}

}  // namespace

const std::vector<std::string>& virtual_structures() {
  static const std::vector<std::string> names = {
      "frame", "ladder", "plate", "portal"};
  return names;
}

std::optional<StructurePreset> preset_of(const std::string& structure) {
  if (structure == "frame") return frame();
  if (structure == "ladder") return ladder();
  if (structure == "plate") return plate();
  if (structure == "portal") return portal();
  return std::nullopt;
}

VirtualModel split_twice(const structure::Deck& deck) {
  VirtualModel model;
  model.model = deck;
  const structure::RefinedDeck once = structure::refine_mesh(model.model);
  const structure::RefinedDeck twice = structure::refine_mesh(once.deck);
  model.fine = twice.deck;
  for (const auto& [id, parts] : once.children) {
    for (const int part : parts) {
      const auto grandchildren = twice.children.find(part);
      if (grandchildren == twice.children.end()) continue;
      std::vector<int>& all = model.children[id];
      all.insert(all.end(),
                 grandchildren->second.begin(),
                 grandchildren->second.end());
    }
  }
  return model;
}

VirtualModel with_truth(const structure::Deck& deck,
                        const structure::Deck& truth) {
  constexpr double same_place = 1e-6;  // [m], of coordinates with six digits
  for (const structure::Grid& grid : deck.grids) {
    const bool there =
        truth.has_grid(grid.id) &&
        (truth.grid(grid.id).position - grid.position).norm() < same_place;
    if (there) continue;
    throw InputError(
        fmt::format("grid {} of the model is not in the truth", grid.id),
        "virtual structure",
        "Give it a grid with that id, at that place, in the deck of --truth.");
  }
  return {deck, truth, {}};
}

}  // namespace tapfit::updating
