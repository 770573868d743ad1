#include "updating/virtual_test/virtual_panel.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::Deck;

/// Raster lines of one axis and the span that follows each.
struct Axis {
  std::vector<double> lines;
  std::vector<std::size_t> span;
};

Axis make_axis(const std::vector<PanelSpan>& spans, int split) {
  Axis axis;
  double start = 0.0;
  for (std::size_t s = 0; s < spans.size(); ++s) {
    const int count = spans[s].elements * split;
    for (int k = 0; k < count; ++k) {
      axis.lines.push_back(start + spans[s].length * k / count);
      axis.span.push_back(s);
    }
    start += spans[s].length;
  }
  axis.lines.push_back(start);
  return axis;
}

using Cell = std::pair<int, int>;  // raster column and row

std::vector<Cell> plate_cells(const Panel& panel,
                              const Axis& x,
                              const Axis& y) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < x.span.size(); ++i) {
    for (std::size_t j = 0; j < y.span.size(); ++j) {
      if (panel.fields.at(x.span[i]).at(y.span[j]) == '#') {
        cells.emplace_back(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }
  return cells;
}

constexpr std::array<Cell, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

std::map<Cell, int> number_grids(const std::vector<Cell>& cells, int first) {
  std::map<Cell, int> ids;
  for (const Cell& cell : cells) {
    for (const auto& [i, j] : corners) {
      ids.emplace(Cell{cell.first + i, cell.second + j}, 0);
    }
  }
  for (auto& [place, id] : ids) id = first++;
  return ids;
}

// Ids of the raster points: those of the model first, the others after.
std::map<Cell, int> split_ids(const std::map<Cell, int>& model,
                              std::map<Cell, int> fine,
                              int split) {
  int next = static_cast<int>(model.size()) + 1;
  for (auto& [place, id] : fine) {
    const auto& [i, j] = place;
    const bool shared = i % split == 0 && j % split == 0;
    id = shared ? model.at({i / split, j / split}) : next++;
  }
  return fine;
}

void add_properties(const Panel& panel, Deck& deck) {
  structure::Material material;
  material.id = 1;
  material.E = panel.E;
  material.nu = panel.nu;
  material.G = panel.E / (2.0 * (1.0 + panel.nu));
  material.rho = panel.rho;
  deck.materials[1] = material;
  structure::ShellProperty shell;
  shell.id = shell.membrane = shell.bending = shell.shear = 1;
  shell.thickness = panel.thickness;
  deck.shell_properties[1] = shell;
  deck.coupled_mass = true;
}

}  // namespace

PanelMesh mesh_panel(const Panel& panel, int split) {
  const Axis x = make_axis(panel.x, split);
  const Axis y = make_axis(panel.y, split);
  const std::vector<Cell> coarse =
      plate_cells(panel, make_axis(panel.x, 1), make_axis(panel.y, 1));
  std::map<Cell, int> element_ids;
  for (const Cell& cell : coarse) {
    element_ids[cell] = static_cast<int>(element_ids.size()) + 1;
  }
  const std::vector<Cell> cells = plate_cells(panel, x, y);
  const std::map<Cell, int> grids =
      split_ids(number_grids(coarse, 1), number_grids(cells, 1), split);

  PanelMesh mesh;
  add_properties(panel, mesh.deck);
  for (const auto& [place, id] : grids) {
    const auto i = static_cast<std::size_t>(place.first);
    const auto j = static_cast<std::size_t>(place.second);
    mesh.deck.grids.push_back({id, {x.lines[i], y.lines[j], 0.0}});
    if (panel.clamped && i == 0) {
      mesh.deck.constraints.push_back({id, "123456"});
    }
  }
  for (const Cell& cell : cells) {
    structure::Shell shell;
    shell.id = static_cast<int>(mesh.deck.shells.size()) + 1;
    shell.property = 1;
    for (const auto& [i, j] : corners) {
      shell.grids.push_back(grids.at({cell.first + i, cell.second + j}));
    }
    mesh.deck.shells.push_back(shell);
    const Cell parent{cell.first / split, cell.second / split};
    mesh.children[element_ids.at(parent)].push_back(shell.id);
  }
  return mesh;
}

std::vector<std::string> panel_cards(const Panel& panel,
                                     const PanelMesh& mesh) {
  std::vector<std::string> cards{"$ " + panel.title,
                                 "$ Units: m, kg, s, N, Pa",
                                 "SOL 103",
                                 "CEND",
                                 "BEGIN BULK",
                                 "PARAM,COUPMASS,1"};
  for (const structure::Grid& grid : mesh.deck.grids) {
    cards.push_back(fmt::format("GRID,{},,{:.6f},{:.6f},0.",
                                grid.id,
                                grid.position.x(),
                                grid.position.y()));
  }
  for (const structure::Shell& shell : mesh.deck.shells) {
    cards.push_back(
        fmt::format("CQUAD4,{},1,{}", shell.id, fmt::join(shell.grids, ",")));
  }
  cards.push_back(fmt::format("PSHELL,1,1,{},1,,1", panel.thickness));
  cards.push_back(
      fmt::format("MAT1,1,{:.4e},,{},{:.1f}", panel.E, panel.nu, panel.rho));
  for (const structure::Constraint& held : mesh.deck.constraints) {
    cards.push_back(fmt::format("SPC1,1,{},{}", held.components, held.grid));
  }
  cards.emplace_back("ENDDATA");
  return cards;
}

Panel frame_panel() {
  Panel panel;
  panel.title = "Aluminium solar panel frame";
  panel.x = {{0.06, 2}, {0.36, 12}, {0.06, 2}, {0.36, 12}, {0.06, 2}};
  panel.y = {{0.06, 2}, {0.43, 14}, {0.06, 2}};
  panel.fields = {"###", "#.#", "###", "#.#", "###"};
  panel.thickness = 0.003;
  panel.clamped = true;
  return panel;
}

Panel ladder_panel() {
  Panel panel;
  panel.title = "Aluminium ladder";
  panel.x.push_back({0.04, 2});
  panel.fields.emplace_back("###");
  for (int rung = 1; rung < 5; ++rung) {
    panel.x.push_back({0.20, 8});
    panel.fields.emplace_back("#.#");
    panel.x.push_back({0.04, 2});
    panel.fields.emplace_back("###");
  }
  panel.y = {{0.04, 2}, {0.20, 8}, {0.04, 2}};
  panel.thickness = 0.004;
  panel.clamped = true;
  return panel;
}

Panel plate_panel() {
  Panel panel;
  panel.title = "Free aluminium plate";
  panel.x = {{0.48, 30}};
  panel.y = {{0.32, 20}};
  panel.fields = {"#"};
  panel.thickness = 0.003;
  return panel;
}

}  // namespace tapfit::updating
