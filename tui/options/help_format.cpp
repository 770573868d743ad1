#include "tui/options/help_format.hpp"

#include "tui/options/recordings_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace tapfit::tui {
namespace {

std::string replaced(std::string text,
                     std::string_view what,
                     std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// The parser's own words for types and ranges say nothing to a reader.
std::string plain_type(const std::string& type) {
  if (type == "FLOAT") return "NUMBER";
  return type == "INT" || type == "UINT" ? "N" : type;
}

bool is_parsers_own(const std::string& check) {
  return check.empty() || check == "NONNEGATIVE" || check == "POSITIVE" ||
         check == "NUMBER" || check.find(" in [") != std::string::npos;
}

/// What is written behind the option's name.
std::string value_words(const CLI::Option& option) {
  const std::string words = option.get_type_name();
  const std::size_t colon = words.find(':');
  const std::string type = plain_type(words.substr(0, colon));
  const std::string check =
      colon == std::string::npos ? "" : words.substr(colon + 1);
  constexpr std::size_t most = 60;  // more are no help in a line
  if (check.starts_with('{') && check.size() <= most) {
    return replaced(check.substr(1, check.size() - 2), ",", "|");
  }
  if (!is_parsers_own(check) && !check.starts_with('{')) return check;
  std::string values = type;
  const bool one_word = type.find(' ') == std::string::npos;
  for (int k = 1; one_word && k < option.get_expected_min(); ++k) {
    values += " " + type;
  }
  return values;
}

std::string without_value(const std::string& name) {
  return name.substr(0, name.find('{'));
}

std::string named(const std::set<CLI::Option*>& options) {
  std::string names;
  for (const CLI::Option* option : options) {
    names += (names.empty() ? "" : ", ") + without_value(option->get_name());
  }
  return names;
}

}  // namespace

HelpFormat::HelpFormat() {
  label("SUBCOMMAND", "COMMAND");
  label("Positionals", "Arguments");
}

std::string HelpFormat::make_option_name(const CLI::Option* option,
                                         bool is_positional) const {
  const std::string name =
      CLI::Formatter::make_option_name(option, is_positional);
  return without_value(name) + (name.starts_with("--csv{") ? "[=TABLE]" : "");
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  std::string words;
  if (!option->get_positional()) {
    const std::string value = value_words(*option);
    words += (value.empty() ? "" : " ") + value;
  }
  if (!option->get_default_str().empty()) {
    words += fmt::format(" [{}]", option->get_default_str());
  }
  if (option->get_required() && !option->get_positional()) {
    words += " (required)";
  }
  if (!option->get_needs().empty()) {
    words += fmt::format(" (with {})", named(option->get_needs()));
  }
  if (!option->get_excludes().empty()) {
    words += fmt::format(" (not with {})", named(option->get_excludes()));
  }
  return words;
}

std::string example_of(const std::string& command) {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 26> behind{{
      {"run", "{}"},
      {"hits", "{} --csv"},
      {"frf", "{} --uff frfs.uff"},
      {"check", "{} --mass 1.9"},
      {"calibrate", "block-test --mass 1.02"},
      {"replay", "{} --speed 4"},
      {"modes", "{} --band 5 60 --uff modes.uff"},
      {"mac", "modes.uff other-modes.csv"},
      {"model", "{}/model.bdf --modes 10"},
      {"uff", "recordings/paper-truss/measured.uff"},
      {"compare", "{} --csv=bands"},
      {"diagnose", "{} --robustness"},
      {"signature", "{} 201"},
      {"update", "{} --effect soft-support --effect sensor-mass"},
      {"predict", "{} --effect added-mass@201=10g"},
      {"together", "bare-test test-with-mass --effect-in 2 added-mass@201"},
      {"session", "{} -o panel.html"},
      {"report", "{} -o panel.md"},
      {"export", "{} --deck updated.bdf"},
      {"import", "taps.csv -o my-test --hammer force@12Z+ --sensor acc@3Z+"},
      {"tour", "--light"},
      {"paper", "truss"},
      {"reveal", "my-challenge"},
      {"simulate", "my-test --structure plate --seed 7"},
      {"challenge", "-o my-challenge --seed 7 --level easy"},
      {"score", "--cases 16"},
  }};
  const auto found = std::ranges::find(behind, command, &Pair::first);
  if (found == behind.end()) return {};
  return fmt::format(
      "Example:\n  tapfit {} {}",
      command,
      replaced(std::string(found->second),
               "{}",
               (recordings_folder() / "solar-panel-frame").string()));
}

}  // namespace tapfit::tui
