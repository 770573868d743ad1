#include "tui/practice/reveal_command.hpp"

#include "tui/options/open_bundle.hpp"
#include "tui/practice/revealed.hpp"
#include "tui/report/json_text.hpp"
#include "updating/practice/played.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session.hpp"
#include "updating/session/session_file.hpp"
#include "updating/virtual_test/truth_seal.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

updating::VirtualBundleSpec hidden_in(const ordered_json& truth) {
  updating::VirtualBundleSpec spec;
  for (const ordered_json& text : truth.at("hidden")) {
    spec.effects.push_back(
        updating::parse_virtual_effect(text.get<std::string>()));
  }
  return spec;
}

// What was done in the terminal, done again; nothing where no effect is on.
std::optional<Answer> played(const fs::path& bundle,
                             const updating::VirtualBundleSpec& hidden,
                             const Progress& progress) {
  updating::Session session(bundle);
  const fs::path file = updating::session_file(session.bundle());
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  const updating::SavedSession saved = updating::read_saved_session(file);
  if (std::ranges::none_of(saved.effects, &updating::AddedEffect::on)) {
    return std::nullopt;
  }
  session.take_up(saved);
  const updating::Diagnosis found = updating::as_diagnosis(
      session.ladder(progress), session.comparison(progress).floor);
  return Answer{
      found.ladder,
      updating::score_diagnosis(hidden, found, session.deck(progress))};
}

Answer diagnosed(updating::Session& session,
                 const updating::VirtualBundleSpec& hidden,
                 const Progress& progress) {
  const updating::Diagnosis& found = session.diagnosis(progress);
  return {found.ladder,
          updating::score_diagnosis(hidden, found, session.deck(progress))};
}

}  // namespace

std::string reveal_command(const CommandOptions& options,
                           const Progress& progress) {
  updating::Session session = open_bundle(options);
  Revealed it;
  it.truth = updating::open_seal(session.bundle().folder);
  const updating::VirtualBundleSpec hidden = hidden_in(it.truth);
  it.session = played(options.input, hidden, progress);
  it.diagnosis = diagnosed(session, hidden, progress);
  return options.json ? json_text(revealed_json(options.input, it))
                      : revealed_text(options.input, it);
}

}  // namespace tapfit::tui
