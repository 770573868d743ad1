#include "tui/report/effect_output.hpp"

#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

ordered_json where_json(const std::string& effect,
                        const updating::Where& where) {
  ordered_json json = ordered_json::object();
  if (effect.starts_with("channel-") && where.channels.size() == 1) {
    json["channel"] = where.channels.front();
    return json;
  }
  if (!where.channels.empty()) json["channels"] = where.channels;
  if (where.node != 0) json["node"] = where.node;
  if (!where.nodes.empty()) json["nodes"] = where.nodes;
  if (!where.elements.empty()) json["elements"] = where.elements;
  return json;
}

ordered_json placed_json(const char* key,
                         const std::string& effect,
                         const updating::Where& where) {
  ordered_json json = {{key, effect}, {"where", where_json(effect, where)}};
  if (!where.variant.empty()) json["variant"] = where.variant;
  return json;
}

ordered_json parameters_json(
    const std::vector<updating::Estimate>& parameters) {
  ordered_json json = ordered_json::object();
  for (const auto& estimate : parameters) {
    json[estimate.name] = {{"value", estimate.value},
                           {"sd", estimate.sd},
                           {"lo95", estimate.lo95},
                           {"hi95", estimate.hi95}};
    if (estimate.at_bound) json[estimate.name]["at_bound"] = true;
  }
  return json;
}

ordered_json model_parameters_json(
    const std::vector<updating::Estimate>& parameters) {
  ordered_json json = ordered_json::object();
  for (const auto& estimate : parameters) {
    json[estimate.name] = {{"value", estimate.value},
                           {"sd", estimate.sd},
                           {"unit", estimate.unit}};
  }
  return json;
}

std::string effect_text(const std::string& effect,
                        const updating::Where& where) {
  const std::string place = describe(where);
  return place.starts_with("everywhere")
             ? effect
             : fmt::format("{} at {}", effect, place);
}

namespace {

/// Two digits, without an exponent where that can be helped.
std::string sd_text(double sd) {
  return sd >= 10.0 && sd < 1e5 ? fmt::format("{:.0f}", sd)
                                : fmt::format("{:.2g}", sd);
}

}  // namespace

std::string parameters_text(const std::vector<updating::Estimate>& parameters) {
  std::string text;
  for (const auto& estimate : parameters) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {} +- {}",
                        estimate.name,
                        short_number(estimate.value),
                        sd_text(estimate.sd));
    if (estimate.at_bound) text += " (at its bound)";
  }
  return text;
}

}  // namespace tapfit::tui
