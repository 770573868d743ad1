#include "updating/session/saved_session.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/saved_effect.hpp"
#include "updating/session/saved_fields.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;
using namespace saved;

constexpr int version = 1;

json to_json(const EffectChange& change) {
  if (change.switched) return {{"switched", *change.switched + 1}};
  if (change.added.size() == 1) return flat(change.added.front());
  json together = json::array();
  for (const EffectRef& ref : change.added) together.push_back(flat(ref));
  return {{"together", together}};
}

EffectChange change_from(const json& value) {
  check_fields(value,
               "a change",
               {"switched",
                "together",
                "effect",
                "node",
                "nodes",
                "elements",
                "channels",
                "variant",
                "at",
                "runs",
                "place_sd",
                "start"});
  if (!value.contains("switched")) {
    EffectChange change;
    for (const json& one : list_in(value, "together")) {
      change.added.push_back(ref_from(one));
    }
    if (change.added.empty()) change.added = {ref_from(value)};
    return change;
  }
  const int effect = index_from(value.at("switched"), "effects");
  return {{}, static_cast<std::size_t>(effect)};
}

json to_json(const EarlyStoppedFit& fit) {
  json effects = json::array();
  for (const EffectRef& effect : fit.effects) {
    effects.push_back(
        {{"effect", effect.effect}, {"where", place_json(effect.where)}});
  }
  return {{"effects", effects}, {"steps", fit.steps}};
}

EarlyStoppedFit kept_from(const json& value) {
  check_fields(value, "a kept fit", {"effects", "steps"});
  EarlyStoppedFit fit;
  for (const json& effect : list_in(value, "effects")) {
    check_fields(effect, "an effect", {"effect", "where"});
    fit.effects.push_back({effect.at("effect"),
                           where_from(effect.value("where", json::object()))});
  }
  fit.steps = index_from(value.at("steps"), "steps") + 1;
  return fit;
}

json to_json(const SavedRung& saved) {
  json parameters = json::object();
  for (const Estimate& e : saved.rung.parameters) {
    parameters[e.name] = {
        {"value", e.value}, {"sd", e.sd}, {"lo95", e.lo95}, {"hi95", e.hi95}};
  }
  json modes = json::array();
  for (const ModePair& pair : saved.modes) {
    modes.push_back({{"measured", pair.measured + 1},
                     {"model", pair.model + 1},
                     {"measured_hz", pair.measured_hz},
                     {"model_hz", pair.model_hz},
                     {"error_percent", pair.error_percent},
                     {"mac", pair.has_shape ? json(pair.mac) : json()}});
  }
  return {{"added", saved.rung.added},
          {"where", place_json(saved.rung.where)},
          {"error", saved.rung.error},
          {"parameters", parameters},
          {"modes", modes}};
}

SavedRung rung_from(const json& value) {
  SavedRung saved;
  saved.rung.added = value.at("added");
  saved.rung.where = where_from(value.at("where"));
  saved.rung.error = value.at("error");
  for (const auto& [name, e] : value.at("parameters").items()) {
    saved.rung.parameters.push_back(
        {name, e.at("value"), e.at("sd"), e.at("lo95"), e.at("hi95")});
  }
  for (const json& m : value.at("modes")) {
    ModePair pair;
    const json& model = m.at("model");
    pair.measured = index_from(m.at("measured"), "modes");
    pair.model = model == 0 ? -1 : index_from(model, "modes");
    pair.measured_hz = m.at("measured_hz");
    pair.model_hz = m.at("model_hz");
    pair.error_percent = m.at("error_percent");
    pair.has_shape = !m.at("mac").is_null();
    if (pair.has_shape) pair.mac = m.at("mac");
    saved.modes.push_back(pair);
  }
  return saved;
}

json to_json(const ModeChoices& choices) {
  json result = json::object();
  if (choices.band_hz) result["band_hz"] = *choices.band_hz;
  result["edits"] = json::array();
  for (const modal::PoleEdit& edit : choices.edits) {
    const bool drop = edit.what == modal::PoleEdit::What::Drop;
    result["edits"].push_back({{drop ? "drop_hz" : "add_hz", edit.hz}});
  }
  result["pairs"] = json::array();
  for (const PairByHand& pair : choices.pairs) {
    json one{{"measured_hz", pair.measured_hz}, {"model", "none"}};
    if (pair.model >= 0) one["model"] = pair.model + 1;
    result["pairs"].push_back(std::move(one));
  }
  return result;
}

double frequency_from(const json& value) {
  const auto hz = value.get<double>();
  if (!(hz >= 0.0)) throw std::out_of_range("a frequency is not negative");
  return hz;
}

ModeChoices choices_from(const json& value) {
  check_fields(value, "\"modes\"", {"band_hz", "edits", "pairs"});
  ModeChoices choices;
  if (value.contains("band_hz")) {
    const json& band = value.at("band_hz");
    choices.band_hz = {frequency_from(band.at(0)), frequency_from(band.at(1))};
  }
  using What = modal::PoleEdit::What;
  for (const json& edit : list_in(value, "edits")) {
    const bool drop = edit.contains("drop_hz");
    choices.edits.push_back(
        {drop ? What::Drop : What::Add,
         frequency_from(edit.at(drop ? "drop_hz" : "add_hz"))});
  }
  for (const json& pair : list_in(value, "pairs")) {
    const json& model = pair.at("model");
    choices.pairs.push_back(
        {frequency_from(pair.at("measured_hz")),
         model == "none" ? -1 : index_from(model, "modes")});
  }
  return choices;
}

std::size_t place_in(const json& hit, const char* key) {
  return static_cast<std::size_t>(index_from(hit.at(key), "runs and hits"));
}

std::vector<OverruledHit> hits_from(const json& list) {
  std::vector<OverruledHit> hits;
  for (const json& hit : list) {
    check_fields(hit, "a hit", {"run", "hit", "together"});
    hits.push_back({place_in(hit, "run"),
                    place_in(hit, "hit"),
                    hit.value("together", false)});
  }
  return hits;
}

json to_json(const std::vector<OverruledHit>& hits) {
  json list = json::array();
  for (const OverruledHit& hit : hits) {
    list.push_back({{"run", hit.run + 1}, {"hit", hit.hit + 1}});
    if (hit.together) list.back()["together"] = true;
  }
  return list;
}

SavedSession session_from(const json& value) {
  if (value.at("tapfit_session").get<int>() != version) {
    throw std::out_of_range(
        fmt::format("\"tapfit_session\" is not {}", version));
  }
  check_fields(value,
               "the session",
               {"tapfit_session",
                "title",
                "overruled_hits",
                "restored_hits",
                "modes",
                "effects",
                "undone",
                "kept_fits",
                "ladder"});
  SavedSession session;
  session.title = value.value("title", "");
  session.overruled = hits_from(list_in(value, "overruled_hits"));
  session.restored = hits_from(list_in(value, "restored_hits"));
  session.modes = choices_from(value.value("modes", json::object()));
  for (const json& effect : list_in(value, "effects")) {
    check_fields(effect,
                 "an effect",
                 {"effect", "where", "place_sd", "start", "on", "together"});
    session.effects.push_back(
        {found_in(effect, where_from(effect.value("where", json::object()))),
         effect.value("on", true),
         effect.value("together", false)});
  }
  for (const json& change : list_in(value, "undone")) {
    session.undone.push_back(change_from(change));
  }
  for (const json& fit : list_in(value, "kept_fits")) {
    session.kept.push_back(kept_from(fit));
  }
  for (const json& rung : list_in(value, "ladder")) {
    session.ladder.push_back(rung_from(rung));
  }
  return session;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw InputError(
      "no saved session: " + what,
      file.string(),
      "correct the file by hand, or move it away to start from the base model");
}

}  // namespace

std::string as_text(const SavedSession& session) {
  json value{{"tapfit_session", version},
             {"title", session.title},
             {"overruled_hits", to_json(session.overruled)},
             {"restored_hits", to_json(session.restored)},
             {"modes", to_json(session.modes)},
             {"effects", json::array()},
             {"undone", json::array()},
             {"kept_fits", json::array()},
             {"ladder", json::array()}};
  for (const AddedEffect& added : session.effects) {
    json one{{"effect", added.ref.effect},
             {"where", place_json(added.ref.where)},
             {"on", added.on}};
    add_found(added.ref, one);
    if (added.together) one["together"] = true;
    value["effects"].push_back(std::move(one));
  }
  for (const EffectChange& change : session.undone) {
    value["undone"].push_back(to_json(change));
  }
  for (const EarlyStoppedFit& fit : session.kept) {
    value["kept_fits"].push_back(to_json(fit));
  }
  for (const SavedRung& rung : session.ladder) {
    value["ladder"].push_back(to_json(rung));
  }
  return value.dump(2) + "\n";
}

void write_saved_session(const fs::path& file, const SavedSession& session) {
  acquisition::write_file(file, as_text(session), {{}, true});
}

SavedSession read_saved_session(const fs::path& file) {
  std::ifstream stream =
      acquisition::open_input(file, acquisition::most_text_bytes);
  if (!stream) {
    throw InputError("cannot be opened",
                     file.string(),
                     "give a session that tapfit saved, BUNDLE/session.json");
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    return session_from(json::parse(text));
  } catch (const json::exception& error) {
    // "[json.exception.type_error.302] (/effects/0/on) type must be ..."
    const std::string what = error.what();
    refuse(file, what.substr(what.find("] ") + 2));
  } catch (const std::out_of_range& error) {
    refuse(file, error.what());
  }
}

}  // namespace tapfit::updating
