#include "acquisition/bundle/test_notes.hpp"

#include "acquisition/foundation/input_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace tapfit::acquisition {
namespace {

using nlohmann::ordered_json;

/// Of the fields that say how the test is worked out.
constexpr std::array<std::string_view, 22> no_facts{"tapfit",
                                                    "title",
                                                    "model",
                                                    "units",
                                                    "channels",
                                                    "runs",
                                                    "frfs",
                                                    "modes",
                                                    "geometry",
                                                    "band_hz",
                                                    "uncertain",
                                                    "limits",
                                                    "weighed",
                                                    "suspension_hz",
                                                    "ignore_cards",
                                                    "trigger_percent",
                                                    "trigger_range_percent",
                                                    "trigger_slope",
                                                    "trigger_rearm_percent",
                                                    "hold_off_s",
                                                    "pre_trigger_s",
                                                    "block_s"};

/// Of a channel: what the table of channels has columns of its own for.
constexpr std::array<std::string_view, 12> channel_fields{"name",
                                                          "quantity",
                                                          "unit",
                                                          "sensitivity",
                                                          "sensitivity_unit",
                                                          "full_scale_volts",
                                                          "mass_kg",
                                                          "height_m",
                                                          "type",
                                                          "serial",
                                                          "calibrated",
                                                          "calibration_due"};

std::optional<double> number_in(const ordered_json& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) return std::nullopt;
  const ordered_json& value = object[key];
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::string text_of(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number()) return fmt::format("{:.6g}", value.get<double>());
  return {};
}

/// "temperature_c" to "temperature" and its unit.
std::pair<std::string, std::string> words_of(std::string key) {
  using Ending = std::pair<std::string_view, const char*>;
  static constexpr std::array<Ending, 6> endings{{{"_c", " °C"},
                                                  {"_percent", " %"},
                                                  {"_kg", " kg"},
                                                  {"_m", " m"},
                                                  {"_s", " s"},
                                                  {"_hz", " Hz"}}};
  std::string unit;
  for (const auto& [ending, name] : endings) {
    if (key.ends_with(ending) && key.size() > ending.size()) {
      key.resize(key.size() - ending.size());
      unit = name;
      break;
    }
  }
  std::replace(key.begin(), key.end(), '_', ' ');
  return {key, unit};
}

void add_facts(const ordered_json& object,
               const std::string& before,
               TestNotes& notes) {
  for (const auto& [key, value] : object.items()) {
    if (before.empty() && std::ranges::count(no_facts, key) > 0) continue;
    auto [name, unit] = words_of(key);
    if (!before.empty()) name = before + " " + name;
    if (value.is_object() && before.empty()) {
      add_facts(value, name, notes);
      continue;
    }
    const std::string text = text_of(value);
    if (text.empty()) continue;
    notes.facts.emplace_back(name, value.is_number() ? text + unit : text);
  }
}

ChannelNotes notes_of(const ordered_json& channel) {
  const auto field = [&](const char* key) {
    return channel.contains(key) ? text_of(channel[key]) : std::string();
  };
  ChannelNotes notes{field("type"),
                     field("serial"),
                     field("calibrated"),
                     field("calibration_due"),
                     {}};
  for (const auto& [key, value] : channel.items()) {
    const std::string text = text_of(value);
    if (text.empty() || std::ranges::count(channel_fields, key) > 0) continue;
    const auto [name, unit] = words_of(key);
    notes.others.emplace_back(name, value.is_number() ? text + unit : text);
  }
  return notes;
}

}  // namespace

TestNotes read_test_notes(const std::filesystem::path& bundle) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(bundle, ignored);
  std::ifstream stream =
      open_input(folder ? bundle / "test.json" : bundle, most_text_bytes);
  const ordered_json document =
      ordered_json::parse(stream, nullptr, false, false);
  TestNotes notes;
  if (!document.is_object()) return notes;
  if (document.contains("limits")) {
    const ordered_json& limits = document["limits"];
    notes.limits = {number_in(limits, "frequency_percent"),
                    number_in(limits, "mac"),
                    number_in(limits, "cross_orthogonality"),
                    number_in(limits, "cross_orthogonality_diagonal")};
  }
  if (document.contains("channels") && document["channels"].is_array()) {
    for (const ordered_json& channel : document["channels"]) {
      if (!channel.is_object() || !channel.contains("name")) continue;
      notes.channels[text_of(channel["name"])] = notes_of(channel);
    }
  }
  add_facts(document, "", notes);
  return notes;
}

}  // namespace tapfit::acquisition
