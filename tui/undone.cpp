#include "tui/undone.hpp"

#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;
using updating::AddedEffect;

ordered_json to_json(const EffectChange& change) {
  if (change.switched) return {{"switched", *change.switched + 1}};
  const updating::Where& where = change.added.where;
  return {{"effect", change.added.effect},
          {"node", where.node},
          {"nodes", where.nodes},
          {"elements", where.elements},
          {"channels", where.channels},
          {"variant", where.variant}};
}

EffectChange from_json(const ordered_json& value) {
  EffectChange change;
  if (value.contains("switched")) {
    const auto number = value.at("switched").get<std::size_t>();
    change.switched = number > 0 ? number - 1 : 0;
    return change;
  }
  change.added.effect = value.at("effect");
  updating::Where& where = change.added.where;
  where.node = value.at("node");
  where.nodes = value.at("nodes").get<std::vector<int>>();
  where.elements = value.at("elements").get<std::vector<int>>();
  where.channels = value.at("channels").get<std::vector<std::string>>();
  where.variant = value.at("variant");
  return change;
}

}  // namespace

std::optional<EffectChange> change_between(
    const std::vector<AddedEffect>& before,
    const std::vector<AddedEffect>& after) {
  if (after.size() == before.size() + 1) {
    return EffectChange{after.back().ref, {}};
  }
  if (after.size() != before.size()) return std::nullopt;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after[i].on != before[i].on) return EffectChange{{}, i};
  }
  return std::nullopt;
}

std::string with_undone(const std::string& session_text,
                        const std::vector<EffectChange>& undone) {
  ordered_json value = ordered_json::parse(session_text);
  if (!undone.empty()) {
    value["undone"] = ordered_json::array();
    for (const EffectChange& change : undone) {
      value["undone"].push_back(to_json(change));
    }
  }
  return value.dump(2) + "\n";
}

std::vector<EffectChange> undone_in(const std::string& session_text) {
  try {
    const ordered_json value = ordered_json::parse(session_text);
    std::vector<EffectChange> undone;
    for (const ordered_json& change :
         value.value("undone", ordered_json::array())) {
      undone.push_back(from_json(change));
    }
    return undone;
  } catch (const ordered_json::exception&) {
    return {};  // read_saved_session() says what is wrong with the file
  }
}

}  // namespace tapfit::tui
