#include "tui/report/effect_output.hpp"

#include "tui/report/text_table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

constexpr double bar_length = 30.0;

std::string bar(double error, double longest) {
  if (longest <= 0.0) return {};
  const double length = std::round(bar_length * error / longest);
  return std::string(static_cast<std::size_t>(std::max(length, 1.0)), '#');
}

}  // namespace

ordered_json where_json(const std::string& effect,
                        const updating::Location& where) {
  ordered_json json = ordered_json::object();
  if (effect.starts_with("channel-") && where.channels.size() == 1) {
    json["channel"] = where.channels.front();
    return json;
  }
  if (!where.channels.empty()) json["channels"] = where.channels;
  if (!where.runs.empty()) json["runs"] = where.runs;
  if (where.node != 0) json["node"] = where.node;
  if (!where.at.empty()) json["at"] = where.at;
  if (is_along_axis(where)) json["direction"] = "+" + where.variant;
  if (is_direction(where)) json["direction"] = where.variant;
  if (!where.nodes.empty()) json["nodes"] = where.nodes;
  if (!where.elements.empty()) json["elements"] = where.elements;
  return json;
}

ordered_json placed_json(const char* key,
                         const std::string& effect,
                         const updating::Location& where) {
  ordered_json json = {{key, effect}, {"where", where_json(effect, where)}};
  const bool axis = is_along_axis(where) || is_direction(where);
  if (!where.variant.empty() && !axis) {
    json["variant"] = where.variant;
  }
  return json;
}

ordered_json estimate_json(const updating::Estimate& estimate) {
  ordered_json json = {{"value", estimate.value},
                       {"sd", estimate.sd},
                       {"lo95", estimate.lo95},
                       {"hi95", estimate.hi95}};
  if (!estimate.unit.empty()) json["unit"] = estimate.unit;
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

std::string estimate_text(const updating::Estimate& estimate) {
  return describe(estimate);
}

std::string estimates_text(const std::vector<updating::Estimate>& estimates) {
  std::string text;
  for (const updating::Estimate& estimate : told(estimates)) {
    text += (text.empty() ? "" : ", ") + estimate_text(estimate);
  }
  return text;
}

std::string ladder_text(const updating::Diagnosis& d) {
  double longest = std::max(d.error_base, d.floor);
  for (const auto& rung : d.ladder) longest = std::max(longest, rung.error);

  TextTable table({"<error ladder", "error", "<"});
  const auto add = [&](const std::string& name, double error) {
    table.add({name, percent(error), bar(error, longest)});
  };
  add("base model", d.error_base);
  const bool any = !d.model_parameters.empty();
  if (any) add("uncertain properties fitted", d.error_fitted);
  for (const auto& rung : d.ladder) {
    add("+ " + effect_text(rung.added, rung.where), rung.error);
  }
  add("floor", d.floor);
  return table.text();
}

}  // namespace tapfit::tui
