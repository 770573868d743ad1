#include "tui/practice/revealed.hpp"

#include "tui/practice/verdict_output.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

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
                        estimates_text(rung.parameters));
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

}  // namespace

ordered_json revealed_json(const fs::path& bundle, const Revealed& it) {
  return {{"bundle", bundle.string()},
          {"seed", it.truth.at("seed")},
          {"structure", it.truth.at("structure")},
          {"hidden", it.truth.at("effects")},
          {"session",
           it.session ? answer_json(*it.session) : ordered_json(nullptr)},
          {"diagnosis", answer_json(it.diagnosis)}};
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

}  // namespace tapfit::tui
