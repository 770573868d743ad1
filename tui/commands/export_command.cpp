#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "tui/app/all_plots.hpp"
#include "tui/app/session_workbench.hpp"
#include "tui/commands/command_table.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/csv_table.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/measured_uff.hpp"
#include "updating/export/shapes_vtu.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/session/add_diagnosed.hpp"
#include "updating/session/session.hpp"
#include "updating/structure/edit/card_difference.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

/// Those named; for a deck where none is, what the diagnosis supports.
void add_effects(updating::Session& session,
                 const CommandOptions& options,
                 const Progress& progress) {
  for (const auto& text : options.effects) {
    session.add(updating::parse_effect(text), progress);
  }
  if (options.effects.empty() && options.deck) {
    updating::add_diagnosed(session, progress);
  }
}

ordered_json cards_json(const std::vector<structure::CardChange>& cards) {
  ordered_json list = ordered_json::array();
  for (const structure::CardChange& change : cards) {
    list.push_back({{"card", change.card},
                    {"where", change.where},
                    {"before", change.before},
                    {"after", change.after}});
  }
  return list;
}

// As a diff: a sign, then the card.
std::string cards_text(const std::vector<structure::CardChange>& cards) {
  constexpr std::size_t shown = 30;
  std::string text;
  for (std::size_t k = 0; k < std::min(shown, cards.size()); ++k) {
    text += fmt::format("  {}\n", cards[k].where);
    if (!cards[k].before.empty()) text += "  - " + cards[k].before + "\n";
    if (!cards[k].after.empty()) text += "  + " + cards[k].after + "\n";
  }
  if (cards.size() > shown) {
    text += fmt::format("  and {} cards more: --json lists all\n",
                        cards.size() - shown);
  }
  return text;
}

acquisition::UffNodes nodes_as(const CommandOptions& options) {
  return options.node_dataset == 15 ? acquisition::UffNodes::D15
                                    : acquisition::UffNodes::D2411;
}

/// Below the folder, which is made where it is not there.
void write_into(const std::filesystem::path& folder,
                std::vector<acquisition::FileContent> files,
                const acquisition::OutputRule& rule,
                std::vector<std::string>& written) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  for (acquisition::FileContent& file : files) {
    file.path = folder / file.path;
    written.push_back(file.path.string());
  }
  acquisition::write_files(files, rule);
}

std::vector<acquisition::FileContent> plots_of(const CommandOptions& options,
                                               const Progress& progress) {
  std::unique_ptr<Workbench> bench =
      open_session(options.input, Work::Forgotten);
  std::vector<updating::EffectRef> effects;
  for (const auto& text : options.effects) {
    effects.push_back(updating::parse_effect(text));
  }
  if (!effects.empty()) bench->add_together(effects, progress);
  std::vector<acquisition::FileContent> files;
  for (PlotFile& plot : all_plots(std::move(bench), progress)) {
    files.push_back({std::move(plot.ending), std::move(plot.content)});
  }
  return files;
}

/// Those of the commands that the test allows.
std::vector<acquisition::FileContent> tables_of(
    const CommandOptions& options,
    const updating::Session& session,
    const Progress& progress) {
  const acquisition::TestBundle& bundle = session.bundle();
  std::vector<std::string_view> wanted{"modes"};
  if (!bundle.runs.empty()) wanted.emplace_back("hits");
  if (!bundle.modes) wanted.emplace_back("frf");
  if (session.has_model()) {
    wanted.emplace_back("compare");
    wanted.emplace_back(options.effects.empty() ? "diagnose" : "update");
  }
  CommandOptions own;
  own.input = options.input;
  own.inside = options.inside;
  own.effects = options.effects;
  own.json = true;
  std::vector<acquisition::FileContent> files;
  for (const CommandEntry& entry : command_table()) {
    if (std::ranges::count(wanted, entry.name) == 0) continue;
    files.push_back({std::string(entry.name) + ".csv",
                     csv_table(entry.command(own, progress), entry.table)});
  }
  return files;
}

}  // namespace

std::string export_command(const CommandOptions& options,
                           const Progress& progress) {
  updating::Session session = open_bundle(options);
  if (options.deck) {
    updating::check_has_deck(session);
    updating::check_deck_name(session.bundle(), *options.deck);
  }
  const acquisition::OutputRule rule = output_rule(session.bundle(), options);
  std::vector<std::string> written;
  if (options.uff) {
    updating::write_measured_uff(
        session, *options.uff, rule, nodes_as(options), progress);
    written.push_back(options.uff->string());
  }
  if (options.records) {
    updating::write_recorded_uff(session,
                                 *options.records,
                                 rule,
                                 options.text_records
                                     ? acquisition::UffEncoding::Text
                                     : acquisition::UffEncoding::Binary,
                                 nodes_as(options),
                                 progress);
    written.push_back(options.records->string());
  }
  if (options.deck || options.vtu) add_effects(session, options, progress);
  if (options.vtu) {
    updating::write_shapes_vtu(session, *options.vtu, rule, progress);
    for (const auto& file : updating::vtu_files(*options.vtu)) {
      written.push_back(file.string());
    }
  }
  updating::WrittenDeck deck;
  if (options.deck) {
    deck = updating::write_updated_deck(session, *options.deck, rule, progress);
    for (const auto& file : deck.files) written.push_back(file.string());
  }
  if (options.plots) {
    write_into(*options.plots, plots_of(options, progress), rule, written);
  }
  if (options.tables) {
    write_into(
        *options.tables, tables_of(options, session, progress), rule, written);
  }
  std::vector<structure::CardChange> cards;
  if (options.deck) {
    cards = structure::card_difference(*session.bundle().deck, *options.deck);
  }
  if (options.json) {
    ordered_json json{{"written", written}};
    if (options.deck) json["cards"] = cards_json(cards);
    return json_text(json);
  }
  std::string text;
  for (const auto& file : written) text += "written: " + file + "\n";
  text += cards_text(cards);
  for (const auto& note : deck.notes) text += "  note: " + note + "\n";
  return text;
}

}  // namespace tapfit::tui
