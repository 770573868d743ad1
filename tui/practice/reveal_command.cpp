#include "tui/practice/reveal_command.hpp"

#include "tui/options/open_bundle.hpp"
#include "tui/practice/verdict_output.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"
#include "updating/practice/played.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session.hpp"
#include "updating/session/session_file.hpp"
#include "updating/virtual_test/truth_seal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// What somebody, or the program, found, and what it is worth.
struct Answer {
  std::vector<updating::Rung> effects;
  updating::Verdict verdict;
};

struct Revealed {
  ordered_json truth;
  std::optional<Answer> session;  ///< nothing: no effect was added yet
  Answer diagnosis;
};

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
  return Answer{found.ladder,
                updating::judge(hidden, found, session.deck(progress))};
}

Answer diagnosed(updating::Session& session,
                 const updating::VirtualBundleSpec& hidden,
                 const Progress& progress) {
  const updating::Diagnosis& found = session.diagnosis(progress);
  return {found.ladder, updating::judge(hidden, found, session.deck(progress))};
}

ordered_json answer_json(const Answer& answer) {
  ordered_json json = verdict_json(answer.verdict);
  ordered_json effects = ordered_json::array();
  for (const updating::Rung& rung : answer.effects) {
    ordered_json one = placed_json("effect", rung.added, rung.where);
    one["parameters"] = parameters_json(rung.parameters);
    effects.push_back(std::move(one));
  }
  json["effects"] = std::move(effects);
  return json;
}

ordered_json revealed_json(const fs::path& bundle, const Revealed& it) {
  return {{"bundle", bundle.string()},
          {"seed", it.truth.at("seed")},
          {"structure", it.truth.at("structure")},
          {"hidden", it.truth.at("effects")},
          {"session",
           it.session ? answer_json(*it.session) : ordered_json(nullptr)},
          {"diagnosis", answer_json(it.diagnosis)}};
}

std::string hidden_text(const ordered_json& truth) {
  std::string text = "Hidden: " + truth.at("effect").get<std::string>() + "\n";
  for (const ordered_json& effect : truth.at("effects")) {
    text += "  " + effect.at("effect").get<std::string>();
    for (const auto& [name, value] : effect.items()) {
      if (name == "effect") continue;
      text += fmt::format(", {} {}",
                          name,
                          value.is_number_float()
                              ? short_number(value.get<double>())
                              : value.dump());
    }
    text += "\n";
  }
  return text;
}

std::string answer_text(const char* whose, const Answer& answer) {
  std::string text = fmt::format("{}: {}\n", whose, answer.verdict.found);
  for (const updating::Rung& rung : answer.effects) {
    text += fmt::format("  {}: {}\n",
                        effect_text(rung.added, rung.where),
                        updating::parameters_text(rung.parameters));
  }
  return text;
}

std::string nothing_yet(const Revealed& it, const fs::path& bundle) {
  const bool nothing = it.truth.at("effects").empty();
  return fmt::format(
      "You: no effect is in session.json yet{}\n",
      nothing ? ", and none is hidden: right, if that is your answer"
              : fmt::format("; open it with tapfit {}", bundle.string()));
}

std::string revealed_text(const fs::path& bundle, const Revealed& it) {
  TextTable table({"<", "<effect", "<place", "<size", "error", "floor"});
  const auto add = [&table](const char* whose, const Answer& answer) {
    std::vector<std::string> row = verdict_row(answer.verdict);
    row.insert(row.begin(), whose);
    table.add(std::move(row));
  };
  if (it.session) add("you", *it.session);
  add("the program", it.diagnosis);
  return hidden_text(it.truth) +
         (it.session ? answer_text("You", *it.session)
                     : nothing_yet(it, bundle)) +
         answer_text("The program", it.diagnosis) + "\n" + table.text();
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
  return options.json ? revealed_json(options.input, it).dump(2) + "\n"
                      : revealed_text(options.input, it);
}

}  // namespace tapfit::tui
