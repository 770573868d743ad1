#include "tui/commands/export_command.hpp"

#include "acquisition/bundle/uff_records.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "modal/mode_set/uff55.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/add_diagnosed.hpp"
#include "tui/commands/updated_deck.hpp"
#include "tui/options/open_bundle.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

void add_effects(updating::Session& session,
                 const CommandOptions& options,
                 const Progress& progress) {
  for (const auto& text : options.effects) {
    session.add(updating::parse_effect(text), progress);
  }
  if (options.effects.empty()) add_diagnosed(session, progress);
}

}  // namespace

void check_deck_path(updating::Session& session,
                     const std::filesystem::path& path) {
  if (session.bundle().matrices) {
    throw InputError("the model is given as matrices: there is no deck",
                     (session.bundle().folder / "test.json").string(),
                     "leave --deck out, or give the model as a Nastran deck");
  }
  std::error_code missing;
  const auto& own = session.bundle().deck;
  if (own && std::filesystem::equivalent(*own, path, missing)) {
    throw InputError("is the model of the test itself",
                     path.string(),
                     "give the updated deck another name");
  }
}

namespace {

void add_piece(const std::vector<int>& grids,
               bool closed,
               acquisition::UffGeometry& geometry) {
  geometry.trace_lines.push_back(grids);
  if (closed) geometry.trace_lines.back().push_back(grids.front());
}

// Grids and element edges of the deck; nothing without one.
acquisition::UffGeometry geometry_of(updating::Session& session) {
  acquisition::UffGeometry geometry;
  if (!session.bundle().deck) return geometry;
  const structure::Deck& deck = session.deck();
  for (const structure::Grid& grid : deck.grids) {
    geometry.nodes[grid.id] = grid.position;
  }
  for (const auto& shell : deck.shells) add_piece(shell.grids, true, geometry);
  for (const auto& bar : deck.bars) {
    add_piece({bar.grids[0], bar.grids[1]}, false, geometry);
  }
  for (const auto& rod : deck.rods) {
    add_piece({rod.grids[0], rod.grids[1]}, false, geometry);
  }
  return geometry;
}

void finish(std::ofstream& file, const std::filesystem::path& path) {
  if (file.flush()) return;
  throw InputError(
      "cannot be written", path.string(), "check folder and permissions");
}

// What the written deck says that it does not hold.
std::string unwritten(const std::filesystem::path& deck) {
  std::string text;
  std::ifstream file(deck);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("$ not written")) continue;
    text += "  note: " + line.substr(2) + "\n";
  }
  return text;
}

acquisition::UffNodes nodes_as(const CommandOptions& options) {
  return options.node_dataset == 15 ? acquisition::UffNodes::D15
                                    : acquisition::UffNodes::D2411;
}

void write_records(updating::Session& session,
                   const CommandOptions& options,
                   const std::filesystem::path& path) {
  const acquisition::TestBundle& bundle = session.bundle();
  if (bundle.runs.empty()) {
    throw InputError("the bundle holds ready FRFs and no recording",
                     options.input.string(),
                     "write its FRFs with --uff");
  }
  std::error_code missing;
  if (bundle.uff && std::filesystem::equivalent(*bundle.uff, path, missing)) {
    throw InputError("is the recording itself",
                     path.string(),
                     "give the time records another name");
  }
  const acquisition::UffNodes nodes = nodes_as(options);
  std::ofstream file(path, std::ios::binary);
  write_uff_records(bundle,
                    options.text_records ? acquisition::UffEncoding::Text
                                         : acquisition::UffEncoding::Binary,
                    file);
  write_geometry(geometry_of(session), nodes, file);
  finish(file, path);
}

}  // namespace

void write_measured_uff(updating::Session& session,
                        const std::filesystem::path& path,
                        acquisition::UffNodes nodes,
                        const Progress& progress) {
  const std::string& title = session.bundle().title;
  const signal::FrfSet& frfs = session.frfs(progress);
  const modal::ModeSet& modes = session.modes(progress);
  std::ofstream file(path);
  signal::write_frfs_uff(frfs, title, file);
  file << modal::modes_as_uff(modes, title);
  write_geometry(geometry_of(session), nodes, file);
  finish(file, path);
}

std::string export_command(const CommandOptions& options,
                           const Progress& progress) {
  if (!options.uff && !options.deck && !options.records) {
    throw InputError("nothing to export",
                     "tapfit export",
                     "name a file with --uff, --records, --deck or several");
  }
  updating::Session session = open_bundle(options.input);
  std::vector<std::string> written;
  if (options.uff) {
    write_measured_uff(session, *options.uff, nodes_as(options), progress);
    written.push_back(options.uff->string());
  }
  if (options.records) {
    write_records(session, options, *options.records);
    written.push_back(options.records->string());
  }
  if (options.deck) {
    check_deck_path(session, *options.deck);
    add_effects(session, options, progress);
    write_updated_deck(session, *options.deck, progress);
    written.push_back(options.deck->string());
  }
  if (options.json) return ordered_json{{"written", written}}.dump(2) + "\n";
  std::string text;
  for (const auto& file : written) text += "written: " + file + "\n";
  if (options.deck) text += unwritten(*options.deck);
  return text;
}

}  // namespace tapfit::tui
