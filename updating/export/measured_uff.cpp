#include "updating/export/measured_uff.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "modal/mode_set/uff55.hpp"
#include "signal/files/uff58.hpp"
#include "updating/export/point_geometry.hpp"
#include "updating/structure/elements/solid_shapes.hpp"

#include <vector>

namespace tapfit::updating {

namespace {

void add_piece(const std::vector<int>& grids,
               bool closed,
               acquisition::UffGeometry& geometry) {
  geometry.trace_lines.push_back(grids);
  if (closed) geometry.trace_lines.back().push_back(grids.front());
}

// Grids and element edges of the deck, and the test's own points.
acquisition::UffGeometry geometry_of(Session& session) {
  acquisition::UffGeometry geometry = point_geometry(session);
  if (!session.bundle().deck) return geometry;
  const structure::Deck& deck = session.deck();
  for (const structure::Grid& grid : deck.grids) {
    if (grid.id > 0) geometry.nodes[grid.id] = grid.position;
  }
  for (const auto& shell : deck.shells) add_piece(shell.grids, true, geometry);
  for (const auto& solid : deck.solids) {
    for (const auto& [a, b] : structure::solid_edges(solid.grids.size())) {
      add_piece({solid.grids[static_cast<std::size_t>(a)],
                 solid.grids[static_cast<std::size_t>(b)]},
                false,
                geometry);
    }
  }
  for (const auto& bar : deck.bars) {
    add_piece({bar.grids[0], bar.grids[1]}, false, geometry);
  }
  for (const auto& rod : deck.rods) {
    add_piece({rod.grids[0], rod.grids[1]}, false, geometry);
  }
  return geometry;
}

}  // namespace

void write_measured_uff(Session& session,
                        const std::filesystem::path& path,
                        const acquisition::OutputRule& rule,
                        acquisition::UffNodes nodes,
                        const Progress& progress) {
  const std::string& title = session.bundle().title;
  const signal::FrfSet& frfs = session.frfs(progress);
  const modal::ModeSet& modes = session.modes(progress);
  acquisition::OutputFile file(path, rule);
  signal::write_frfs_uff(frfs, title, file.stream());
  file.stream() << modal::modes_as_uff(modes, title);
  write_geometry(geometry_of(session), nodes, file.stream());
  file.commit();
}

void write_recorded_uff(Session& session,
                        const std::filesystem::path& path,
                        const acquisition::OutputRule& rule,
                        acquisition::UffEncoding encoding,
                        acquisition::UffNodes nodes,
                        const Progress& progress) {
  const acquisition::TestBundle& bundle = session.bundle();
  if (bundle.runs.empty()) {
    throw InputError("the bundle holds no recording",
                     bundle.folder.string(),
                     "write its FRFs or modes with --uff");
  }
  acquisition::OutputFile file(path, rule);
  write_uff_records(bundle, encoding, file.stream(), progress);
  write_geometry(geometry_of(session), nodes, file.stream());
  file.commit();
}

}  // namespace tapfit::updating
