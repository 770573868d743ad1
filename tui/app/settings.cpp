#include "tui/app/settings.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "acquisition/foundation/parse_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdlib>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Words that a setting may have, and what each means.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// @return empty where the value was taken, else what may be written
template <class Value, class Chosen>
std::string choose(const json& value,
                   const Choices<Value>& choices,
                   Chosen& chosen) {
  std::vector<std::string> allowed;
  for (const auto& [word, meant] : choices) {
    if (value == word) {
      chosen = meant;
      return {};
    }
    allowed.push_back(word);
  }
  const std::string written = value.is_string() ? value.get<std::string>() : "";
  return fmt::format("is {}: {}write {}",
                     value.dump(),
                     did_you_mean(written, allowed),
                     fmt::join(allowed, ", "));
}

/// Ways out that always have to be there.
bool is_kept(const Key& key) {
  return key == U':' || key == U'q' || key == keys::escape;
}

/// @return empty where the key was bound, else what is wrong
std::string bind(const std::string& key_text,
                 const json& command,
                 std::vector<KeyBinding>& bindings) {
  const std::optional<NamedKey> named = read_key(key_text);
  if (!named || named->bytes != key_text.size()) {
    return "is no key: write one such as F, <C-b>, <Enter> or <Space>";
  }
  if (is_kept(named->key)) return "is always what it is: take another key";
  if (!command.is_string()) return "needs a command, as after ':'";
  const auto text = command.get<std::string>();
  try {
    (void)parse_colon_command(text);
  } catch (const InputError& error) {
    return error.what();
  }
  bindings.push_back({named->key, text, text});
  return {};
}

void bind_all(const json& table, Settings& settings) {
  if (!table.is_object()) {
    settings.faults.emplace_back(
        "keys: write a table of keys and commands, such as {\"F\": \"plot\"}");
    return;
  }
  for (const auto& [key, command] : table.items()) {
    const std::string fault = bind(key, command, settings.keys);
    if (!fault.empty()) {
      settings.faults.push_back(fmt::format("keys: {} {}", key, fault));
    }
  }
}

std::string take(const std::string& name, const json& value, Settings& into) {
  if (name == "theme") {
    return choose<Theme>(value,
                         {{"default", Theme::Default},
                          {"high-contrast", Theme::HighContrast},
                          {"mono", Theme::Mono}},
                         into.theme);
  }
  if (name == "background") {
    return choose<bool>(value, {{"dark", false}, {"light", true}}, into.light);
  }
  if (name == "graphics") {
    return choose<GraphicsWish>(value,
                                {{"auto", GraphicsWish::Auto},
                                 {"kitty", GraphicsWish::Kitty},
                                 {"sixel", GraphicsWish::Sixel},
                                 {"off", GraphicsWish::Off}},
                                into.graphics);
  }
  if (name == "magnitude") {
    return choose<MagnitudeScale>(value,
                                  {{"logarithmic", MagnitudeScale::Logarithmic},
                                   {"linear", MagnitudeScale::Linear},
                                   {"dB", MagnitudeScale::Decibels}},
                                  into.magnitude);
  }
  if (name == "frequency") {
    return choose<bool>(
        value, {{"linear", false}, {"logarithmic", true}}, into.log_frequency);
  }
  const std::vector<std::string> known{
      "theme", "background", "graphics", "magnitude", "frequency", "keys"};
  return fmt::format("is no setting: {}there are {}",
                     did_you_mean(name, known),
                     fmt::join(known, ", "));
}

}  // namespace

std::optional<fs::path> settings_file() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value == nullptr ? "" : value);
  };
  // A relative path there is none (XDG Base Directory Specification).
  fs::path config = folder("XDG_CONFIG_HOME");
  const fs::path home = folder("HOME");
  if (!config.is_absolute() && !home.is_absolute()) return std::nullopt;
  if (!config.is_absolute()) config = home / ".config";
  return config / "tapfit" / "config.json";
}

Settings read_settings(const std::optional<fs::path>& file) {
  Settings settings;
  std::error_code fault;
  if (!file || !fs::exists(*file, fault)) return settings;
  settings.file = file;
  try {
    const json root =
        parse_json(acquisition::read_input(*file), file->filename().string());
    if (!root.is_object()) {
      settings.faults.emplace_back("holds no settings: write { ... }");
      return settings;
    }
    for (const auto& [name, value] : root.items()) {
      if (name == "keys") {
        bind_all(value, settings);
        continue;
      }
      const std::string wrong = take(name, value, settings);
      if (!wrong.empty()) settings.faults.push_back(name + " " + wrong);
    }
  } catch (const InputError& error) {
    settings.faults.emplace_back(error.what());
  }
  return settings;
}

std::string fault_words(const Settings& settings) {
  if (settings.faults.empty()) return {};
  return fmt::format("{}: {}; the rest is as set",
                     settings.file ? settings.file->string() : "settings",
                     fmt::join(settings.faults, "; "));
}

}  // namespace tapfit::tui
