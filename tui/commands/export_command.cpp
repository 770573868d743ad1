#include "tui/commands/export_command.hpp"

#include "acquisition/input_error.hpp"
#include "signal/uff58.hpp"
#include "tui/commands/effect_output.hpp"
#include "tui/commands/updated_deck.hpp"
#include "updating/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

void add_effects(updating::Session& session,
                 const CommandOptions& options,
                 const Progress& progress) {
  for (const auto& text : options.effects) {
    session.add(updating::parse_effect(text), progress);
  }
  if (!options.effects.empty()) return;
  // Copied: adding its rungs to the session drops the session's own.
  const updating::Diagnosis diagnosis = session.diagnosis(progress);
  for (const auto& rung : diagnosis.ladder) {
    const std::string effect = rung.added.substr(0, rung.added.find('|'));
    session.add({effect, rung.where}, progress);
  }
}

}  // namespace

std::string export_command(const CommandOptions& options,
                           const Progress& progress) {
  if (!options.uff && !options.deck) {
    throw InputError("nothing to export",
                     "tapfit export",
                     "name a file with --uff, --deck or both");
  }
  updating::Session session(options.input);
  std::vector<std::string> written;
  if (options.uff) {
    signal::write_frfs_uff(
        session.frfs(progress), session.bundle().title, *options.uff);
    written.push_back(options.uff->string());
  }
  if (options.deck) {
    add_effects(session, options, progress);
    write_updated_deck(session, *options.deck, progress);
    written.push_back(options.deck->string());
  }
  if (options.json) return ordered_json{{"written", written}}.dump(2) + "\n";
  std::string text;
  for (const auto& file : written) text += "written: " + file + "\n";
  return text;
}

}  // namespace tapfit::tui
