#include "updating/session/saved_effect.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating::saved {

using json = nlohmann::ordered_json;

namespace {

Location where_in(const json& value) {
  Location where;
  where.node = value.value("node", 0);
  where.nodes = value.value("nodes", std::vector<int>{});
  where.elements = value.value("elements", std::vector<int>{});
  where.channels = value.value("channels", std::vector<std::string>{});
  where.variant = value.value("variant", "");
  where.at = value.value("at", std::vector<double>{});
  where.runs = value.value("runs", std::vector<int>{});
  if (!where.at.empty() && where.at.size() != 3) {
    throw std::out_of_range("\"at\" takes three coordinates");
  }
  return where;
}

}  // namespace

json place_json(const Location& where) {
  json result = json::object();
  if (where.node != 0) result["node"] = where.node;
  if (!where.nodes.empty()) result["nodes"] = where.nodes;
  if (!where.elements.empty()) result["elements"] = where.elements;
  if (!where.channels.empty()) result["channels"] = where.channels;
  if (!where.variant.empty()) result["variant"] = where.variant;
  if (!where.at.empty()) result["at"] = where.at;
  if (!where.runs.empty()) result["runs"] = where.runs;
  return result;
}

Location where_from(const json& value) {
  check_fields(
      value,
      "\"where\"",
      {"node", "nodes", "elements", "channels", "variant", "at", "runs"});
  return where_in(value);
}

void add_found(const EffectRef& ref, json& value) {
  if (!ref.place_sd.empty()) value["place_sd"] = ref.place_sd;
  if (!ref.start.empty()) value["start"] = ref.start;
}

EffectRef found_in(const json& value, Location where) {
  EffectRef ref{value.at("effect"), std::move(where)};
  ref.place_sd = value.value("place_sd", std::vector<double>{});
  ref.start = value.value("start", std::vector<double>{});
  const auto below = [](double least) {
    return [least](double x) { return !(x >= least); };
  };
  if (std::ranges::any_of(ref.place_sd, below(0.0)) ||
      std::ranges::any_of(ref.start, below(1e-300))) {
    throw std::out_of_range("\"place_sd\" and \"start\" take numbers above 0");
  }
  return ref;
}

json flat(const EffectRef& ref) {
  json result{{"effect", ref.effect}};
  result.update(place_json(ref.where));
  add_found(ref, result);
  return result;
}

EffectRef ref_from(const json& value) {
  check_fields(value,
               "an effect of a change",
               {"effect",
                "node",
                "nodes",
                "elements",
                "channels",
                "variant",
                "at",
                "runs",
                "place_sd",
                "start"});
  return found_in(value, where_in(value));
}

}  // namespace tapfit::updating::saved
