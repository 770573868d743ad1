#include "updating/virtual_test/virtual_effect.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace tapfit::updating {
namespace {

enum class Place { None, Node, Line, Ends, Channel, Channels, Elements, Pair };

struct Kind {
  const char* name;
  Place place;
  std::vector<const char*> values;  ///< parameter names
  std::size_t needed;               ///< of the values
  const char* form = "";            ///< one name may have several
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"sensor-mass", Place::Channels, {"mass_kg", "mass_kg_of_second"}, 1},
      {"sensor-cable",
       Place::Channels,
       {"stiffness_n_per_m", "damping_ns_per_m"},
       2},
      {"soft-support",
       Place::None,
       {"rotational_stiffness_per_m", "rotational_stiffness_per_m_last"},
       1},
      {"soft-support",
       Place::None,
       {"translational_stiffness_per_m", "translational_stiffness_per_m_last"},
       1,
       "translation"},
      {"soft-support",
       Place::None,
       {"rotational_stiffness_per_m", "translational_stiffness_per_m"},
       2,
       "both"},
      {"added-mass", Place::Node, {"mass_kg"}, 1},
      {"ground-spring", Place::Node, {"stiffness_n_per_m"}, 1},
      {"dashpot", Place::Node, {"damping_ns_per_m"}, 1},
      {"stiffness-loss", Place::Elements, {"factor"}, 1},
      {"joint", Place::Line, {"rotational_stiffness_per_m"}, 1},
      {"strut", Place::Ends, {"stiffness_n_per_m"}, 1},
      {"absorber",
       Place::Node,
       {"mass_kg", "frequency_hz", "damping_ratio"},
       2},
      {"channel-gain", Place::Channel, {"gain"}, 1},
      {"channel-delay", Place::Channel, {"delay_s"}, 1},
      {"channel-polarity", Place::Channel, {}, 0},
      {"channel-swap", Place::Pair, {}, 0},
      {"nonlinearity", Place::Node, {"cubic_stiffness_n_per_m3"}, 1},
      {"drift", Place::None, {"percent"}, 1},
      {"wrong-grid", Place::Ends, {}, 0},
  };
  return all;
}

[[noreturn]] void refuse(const std::string& what, const std::string& text) {
  throw InputError(what,
                   "effect \"" + text + "\"",
                   "Write one of:\n" + virtual_effect_help());
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

template <typename Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

void check_places(const Kind& kind,
                  const VirtualEffect& effect,
                  const std::string& text) {
  const std::size_t count = effect.places.size();
  const bool right = kind.place == Place::None       ? count == 0
                     : kind.place == Place::Channels ? true
                     : kind.place == Place::Elements ? count > 0
                     : kind.place == Place::Line     ? count > 0
                     : kind.place == Place::Ends     ? count == 2
                     : kind.place == Place::Pair     ? count == 2
                                                     : count == 1;
  if (!right) refuse("wrong number of places", text);
  const std::set<std::string> different(effect.places.begin(),
                                        effect.places.end());
  if (different.size() < count) refuse("the same place twice", text);
  if (effect.name == "sensor-mass" && count > 0 && effect.values.size() > 1 &&
      effect.values.size() != count) {
    refuse("one mass for all sensors, or one for each", text);
  }
  const bool ids = kind.place == Place::Node || kind.place == Place::Line ||
                   kind.place == Place::Ends || kind.place == Place::Elements;
  if (!ids) return;
  for (const std::string& place : effect.places) {
    if (!number<int>(place)) refuse(place + " is no id", text);
  }
}

const Kind& kind_of(const VirtualEffect& effect, const std::string& text) {
  const auto kind = std::ranges::find_if(kinds(), [&](const Kind& k) {
    return k.name == effect.name && k.form == effect.form;
  });
  if (kind == kinds().end()) refuse("no effect of this name", text);
  return *kind;
}

// "both" of "soft-support@both" is no place.
void take_form(VirtualEffect& effect) {
  if (effect.places.size() != 1) return;
  const bool is_form = std::ranges::any_of(kinds(), [&](const Kind& k) {
    return k.name == effect.name && k.form == effect.places[0];
  });
  const bool turns =
      effect.name == "soft-support" && effect.places[0] == "rotation";
  if (!is_form && !turns) return;
  if (is_form) effect.form = effect.places[0];
  effect.places.clear();
}

void read_values(const std::string& list,
                 const std::string& text,
                 VirtualEffect& effect) {
  for (const std::string& part : split(list, ',')) {
    const std::optional<double> value = number<double>(part);
    if (!value || !std::isfinite(*value)) {
      refuse("'" + part + "' is no number", text);
    }
    // A channel that is early has a negative delay.
    if (*value < 0.0 && effect.name != "channel-delay") {
      refuse("'" + part + "' is negative", text);
    }
    effect.values.push_back(*value);
  }
}

}  // namespace

std::vector<int> VirtualEffect::numbers() const {
  std::vector<int> ids;
  for (const std::string& place : places) ids.push_back(std::stoi(place));
  return ids;
}

VirtualEffect parse_virtual_effect(const std::string& text) {
  VirtualEffect effect;
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string head = text.substr(0, equals);
  const std::size_t at = std::min(head.find('@'), head.size());
  effect.name = head.substr(0, at);
  if (at < head.size()) effect.places = split(head.substr(at + 1), ':');
  take_form(effect);
  const Kind& kind = kind_of(effect, text);
  if (equals < text.size()) {
    read_values(text.substr(equals + 1), text, effect);
  }
  if (effect.values.size() < kind.needed ||
      effect.values.size() > kind.values.size()) {
    refuse("wrong number of values", text);
  }
  check_places(kind, effect, text);
  return effect;
}

std::string virtual_effect_text(const VirtualEffect& effect) {
  std::string text = effect.name;
  if (!effect.form.empty()) text += "@" + effect.form;
  if (!effect.places.empty()) {
    text += fmt::format("@{}", fmt::join(effect.places, ":"));
  }
  if (effect.values.empty()) return text;
  return text + fmt::format("={}", fmt::join(effect.values, ","));
}

std::string virtual_effect_help() {
  static constexpr std::array<const char*, 8> places{"",
                                                     "@NODE",
                                                     "@NODE[:...]",
                                                     "@NODE:NODE",
                                                     "@CHANNEL",
                                                     "[@CHANNEL:...]",
                                                     "@ELEMENT:...",
                                                     "@CHANNEL:CHANNEL"};
  std::string help;
  for (const Kind& kind : kinds()) {
    help += fmt::format("  {}{}{}{}",
                        kind.name,
                        *kind.form == '\0' ? "" : "@",
                        kind.form,
                        places[static_cast<std::size_t>(kind.place)]);
    for (std::size_t k = 0; k < kind.values.size(); ++k) {
      const std::string value =
          (k == 0 ? "=" : ",") + std::string(kind.values[k]);
      help += k < kind.needed ? value : "[" + value + "]";
    }
    help += '\n';
  }
  return help;
}

nlohmann::ordered_json truth_entry(const VirtualEffect& effect,
                                   const std::vector<std::string>& channels) {
  const Kind& kind = kind_of(effect, effect.name);
  nlohmann::ordered_json entry{{"effect", effect.name}};
  switch (kind.place) {
    case Place::None:
      break;
    case Place::Node:
      entry["node"] = effect.numbers().front();
      break;
    case Place::Line:
    case Place::Ends:
      entry["nodes"] = effect.numbers();
      break;
    case Place::Channel:
      entry["channel"] = effect.places.front();
      break;
    case Place::Elements:
      entry["elements"] = effect.numbers();
      break;
    case Place::Pair:
    case Place::Channels:
      entry["channels"] = effect.places.empty() ? channels : effect.places;
      break;
  }
  const bool each = effect.name == "sensor-mass" && effect.values.size() > 1;
  for (std::size_t k = 0; k < effect.values.size(); ++k) {
    entry[each ? "mass_kg." + entry["channels"][k].get<std::string>()
               : kind.values[k]] = effect.values[k];
  }
  return entry;
}

}  // namespace tapfit::updating
