#include "tui/options/misspelt.hpp"

#include "acquisition/foundation/nearest_word.hpp"

#include <fmt/format.h>

#include <array>
#include <regex>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

}  // namespace

std::string meant_words(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& at = chosen.empty() ? app : *chosen.front();
  for (const std::string& word : app.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    const bool option = name.starts_with('-');
    const auto meant =
        nearest_word(name, option ? options_of(at) : commands_of(at));
    if (meant) return fmt::format("Did you mean {}?\n", *meant);
  }
  return {};
}

std::string meant_command(const CLI::App& app, const std::string& word) {
  const auto meant = nearest_word(word, commands_of(app));
  return meant ? fmt::format("Did you mean tapfit {}?\n", *meant)
               : std::string();
}

std::string plain_words(std::string text) {
  using Pair = std::pair<std::regex, const char*>;
  static const std::array<Pair, 4> phrases{
      {{std::regex("(\\S+): At least (\\d+) required but received (\\d+)"),
        "$1 takes $2 values, $3 was given"},
       {std::regex("(\\S+): 1 required (?:\\w+:)?(\\S+) missing"),
        "$1 takes a value: $2"},
       {std::regex("(\\S+): (\\d+) required (?:\\w+:)?(\\S+) missing"),
        "$1 takes $2 values: $3"},
       {std::regex("Value (\\S+) not in range 0\\.0+ to \\d{50,}\\S*"),
        "\"$1\" is not a number from 0 on"}}};
  for (const auto& [said, plain] : phrases) {
    text = std::regex_replace(text, said, plain);
  }
  return text;
}

}  // namespace tapfit::tui
