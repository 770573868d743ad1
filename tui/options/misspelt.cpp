#include "tui/options/misspelt.hpp"

#include "acquisition/foundation/nearest_word.hpp"

#include <fmt/format.h>

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

}  // namespace tapfit::tui
