// The third pass over test.json: what a schema cannot say (names that refer to
// each other, units, files).
#include "acquisition/bundle/read_test_bundle.hpp"

#include "acquisition/bundle/json_source.hpp"
#include "acquisition/bundle/lossy_files.hpp"
#include "acquisition/bundle/read_placement.hpp"
#include "acquisition/bundle/read_test_geometry.hpp"
#include "acquisition/bundle/read_test_json.hpp"
#include "acquisition/bundle/test_schema.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/units.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace tapfit::acquisition {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

using Source = JsonSource;

Channel read_channel(const json& entry,
                     const std::string& place,
                     const Source& source) {
  Channel channel;
  channel.name = entry.at("name").get<std::string>();
  channel.quantity = *find_quantity(entry.at("quantity").get<std::string>());
  channel.unit = entry.at("unit").get<std::string>();
  const std::optional<Unit> unit = find_unit(channel.unit);
  if (!unit || unit->quantity != channel.quantity) {
    throw InputError(fmt::format("\"{}\" is no known unit of {}",
                                 channel.unit,
                                 name(channel.quantity)),
                     source.at(place + ".unit"),
                     "use one of " + known_units(channel.quantity));
  }
  channel.unit_to_si = unit->si;
  channel.sensitivity = entry.at("sensitivity").get<double>();
  if (entry.contains("sensitivity_unit")) {
    const std::string text = entry["sensitivity_unit"].get<std::string>();
    const std::optional<SensitivityUnit> per = find_sensitivity_unit(text);
    if (!per || per->unit.quantity != channel.quantity) {
      throw InputError(fmt::format("\"{}\" is no voltage per unit of {}",
                                   text,
                                   name(channel.quantity)),
                       source.at(place + ".sensitivity_unit"),
                       "use V/x, mV/x or uV/x with x one of " +
                           known_units(channel.quantity));
    }
    channel.sensitivity *= per->volts * unit->si / per->unit.si;
  }
  // Beyond, numbers overflow before they tell anything.
  constexpr double most = 1e12;
  const double size = std::abs(channel.sensitivity);
  if (!(size >= 1.0 / most) || !(size <= most)) {
    throw InputError(
        fmt::format("the sensitivity is {:.6g} V per {}, which no sensor has",
                    channel.sensitivity,
                    channel.unit),
        source.at(place + ".sensitivity"),
        "give the volts per unit of the sensor's sheet: 1e-4 to 1 V/N are "
        "usual, 1e-3 to 1 V/(m/s^2)");
  }
  channel.full_scale_volts = entry.at("full_scale_volts").get<double>();
  if (entry.contains("mass_kg")) {
    channel.mass_kg = entry["mass_kg"].get<double>();
  }
  channel.height_m = entry.value("height_m", 0.0);
  return channel;
}

std::vector<Channel> read_channels(const json& list, const Source& source) {
  std::vector<Channel> channels;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = fmt::format("channels[{}]", i);
    channels.push_back(read_channel(list[i], place, source));
    if (!names.insert(channels.back().name).second) {
      throw InputError(fmt::format("a channel \"{}\" was there before",
                                   channels.back().name),
                       source.at(place + ".name"),
                       "give every channel its own name");
    }
  }
  return channels;
}

fs::path existing_file(const json& entry,
                       const std::string& place,
                       const Source& source) {
  fs::path file = source.folder / entry.get<std::string>();
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    throw InputError(no_file(file),
                     source.at(place),
                     "correct the path; it is relative to test.json's folder");
  }
  return file;
}

Run read_run(const json& entry,
             const std::string& place,
             const std::vector<Channel>& channels,
             const Source& source,
             PlacementReader& placements) {
  Run run;
  run.file = source.folder / entry.at("file").get<std::string>();
  run.hammer = placements.read(entry.at("hammer"), place + ".hammer");
  if (channels[run.hammer.channel].quantity != Quantity::Force) {
    throw InputError("the hammer's channel does not measure force",
                     source.at(place + ".hammer.channel"),
                     "name a channel with \"quantity\": \"force\"");
  }
  std::set<std::size_t> used{run.hammer.channel};
  const json& sensors = entry.at("sensors");
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const std::string here = fmt::format("{}.sensors[{}]", place, i);
    run.sensors.push_back(placements.read(sensors[i], here));
    if (!used.insert(run.sensors.back().channel).second) {
      throw InputError("this channel has a place in this run already",
                       source.at(here + ".channel"),
                       "name each channel once in a run");
    }
  }
  return run;
}

void read_model(const json& model, const Source& source, TestBundle& bundle) {
  if (model.is_string()) {
    bundle.deck = existing_file(model, "model", source);
    return;
  }
  MatrixModel matrices;
  matrices.stiffness =
      existing_file(model.at("stiffness"), "model.stiffness", source);
  matrices.mass = existing_file(model.at("mass"), "model.mass", source);
  matrices.dofs = existing_file(model.at("dofs"), "model.dofs", source);
  bundle.matrices = matrices;
}

ReadyModes read_ready_modes(const json& entry, const Source& source) {
  ReadyModes modes;
  if (entry.is_string()) {
    modes.file = existing_file(entry, "modes", source);
    return modes;
  }
  modes.file = existing_file(entry.at("file"), "modes.file", source);
  modes.frequency_sd_percent =
      entry.value("frequency_sd_percent", modes.frequency_sd_percent);
  modes.shape_sd_percent =
      entry.value("shape_sd_percent", modes.shape_sd_percent);
  return modes;
}

void check_one_measurement(const json& document, const Source& source) {
  const std::array<const char*, 3> kinds{"runs", "frfs", "modes"};
  const auto given = std::ranges::count_if(
      kinds, [&](const char* kind) { return document.contains(kind); });
  if (given == 1) return;
  throw InputError(
      given == 0 ? "needs one of runs, frfs and modes"
                 : "needs only one of runs, frfs and modes",
      source.at("runs"),
      "list the recordings in runs, or name a UFF file in frfs, or a file of "
      "modes in modes");
}

std::array<double, 2> read_band(const json& band, const Source& source) {
  const std::array<double, 2> limits{band[0].get<double>(),
                                     band[1].get<double>()};
  if (limits[0] > 0.0 && limits[1] > limits[0]) return limits;
  throw InputError(
      fmt::format("[{}, {}] is no band", limits[0], limits[1]),
      source.at("band_hz"),
      "give the lower frequency first; it must be above 0 Hz and below the "
      "upper one");
}

Weighed read_weighed(const json& entry) {
  Weighed weighed;
  weighed.mass_kg = entry.at("mass_kg").get<double>();
  weighed.sd_percent = entry.value("sd_percent", weighed.sd_percent);
  if (entry.contains("centre_m")) {
    weighed.centre_m = entry["centre_m"].get<std::array<double, 3>>();
  }
  return weighed;
}

UncertainProperty read_uncertain(const json& entry,
                                 const std::string& place,
                                 const Source& source) {
  const bool material = entry.contains("material");
  if (material == entry.contains("element_property")) {
    throw InputError("says not (or twice) which card is meant",
                     source.at(place),
                     "give either material or element_property, an id");
  }
  UncertainProperty uncertain;
  uncertain.card = material ? "material" : "property";
  uncertain.id =
      entry.at(material ? "material" : "element_property").get<int>();
  uncertain.property = entry.at("property").get<std::string>();
  if (entry.contains("sd_percent")) {
    uncertain.sd_percent = entry["sd_percent"].get<double>();
  }
  return uncertain;
}

void read_runs(const json& document, const Source& source, TestBundle& bundle) {
  if (!document.contains("channels")) {
    throw InputError("there are runs, but no channels",
                     source.at("channels"),
                     "list the channels of the recordings, in their order");
  }
  const json& runs = document["runs"];
  PlacementReader placements(bundle, source);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    bundle.runs.push_back(read_run(runs[i],
                                   fmt::format("runs[{}]", i),
                                   bundle.channels,
                                   source,
                                   placements));
  }
  bundle.points = placements.points();
}

// That there are points which only a model could place.
std::optional<std::string> unplaced_note(const TestBundle& bundle) {
  if (bundle.deck || bundle.matrices) return {};
  const auto first = std::ranges::find_if(bundle.points, needs_model);
  if (first == bundle.points.end()) return {};
  const auto all = std::ranges::count_if(bundle.points, needs_model);
  return fmt::format(
      "no model says where {} of the test's points lie ({}, ...), at grids or "
      "along systems: universal files are written without their places",
      all,
      node_name(-first->label));
}

void read_options(const json& document, TestBundle& bundle) {
  const auto number = [&](const char* key) -> std::optional<double> {
    if (!document.contains(key)) return std::nullopt;
    return document[key].get<double>();
  };
  bundle.title = document.value("title", std::string());
  bundle.units = document.value("units", std::string("SI"));
  bundle.ignored_cards =
      document.value("ignore_cards", std::vector<std::string>());
  bundle.trigger_percent = number("trigger_percent");
  bundle.trigger.range_percent = number("trigger_range_percent");
  bundle.trigger.rearm_percent = number("trigger_rearm_percent");
  bundle.trigger.hold_off_s = number("hold_off_s");
  if (document.contains("trigger_slope")) {
    bundle.trigger.slope = document["trigger_slope"] == "falling" ? -1 : 1;
  }
  bundle.pre_trigger_s = number("pre_trigger_s");
  bundle.block_s = number("block_s");
  // Longer ones have no room in memory, or in an index.
  constexpr double longest_block_s = 3600.0;
  if (bundle.block_s && *bundle.block_s > longest_block_s) {
    throw InputError(
        fmt::format("a block of {} s is too long", *bundle.block_s),
        "test.json: block_s",
        "give at most an hour");
  }
  if (bundle.pre_trigger_s && *bundle.pre_trigger_s > longest_block_s) {
    throw InputError(
        fmt::format("a pre-trigger of {} s is too long", *bundle.pre_trigger_s),
        "test.json: pre_trigger_s",
        "give at most an hour, 2 % of a block for example");
  }
  if (bundle.pre_trigger_s && bundle.block_s &&
      *bundle.pre_trigger_s >= *bundle.block_s) {
    throw InputError(
        fmt::format("a pre-trigger of {} s leaves nothing of a block (block_s) "
                    "of {} s",
                    *bundle.pre_trigger_s,
                    *bundle.block_s),
        "test.json: pre_trigger_s",
        "give a pre_trigger_s far below block_s, 2 % of it for example");
  }
}

}  // namespace

TestBundle read_test_bundle(const fs::path& folder) {
  if (is_uff(folder)) return read_uff_bundle(folder);
  const fs::path file = test_json_of(folder);
  const Source source{file.parent_path(), file.filename().string()};
  const json document = read_test_json(file);
  check_one_measurement(document, source);

  TestBundle bundle;
  bundle.folder = source.folder;
  bundle.file = file;
  read_options(document, bundle);
  if (document.contains("channels")) {
    bundle.channels = read_channels(document["channels"], source);
  }
  if (document.contains("frfs")) {
    bundle.frfs = existing_file(document["frfs"], "frfs", source);
  }
  if (document.contains("modes")) {
    bundle.modes = read_ready_modes(document["modes"], source);
  }
  if (document.contains("geometry")) {
    bundle.geometry = read_test_geometry(document["geometry"], bundle, source);
  }
  if (document.contains("runs")) read_runs(document, source, bundle);
  if (const auto named = points_file(bundle)) {
    bundle.points = points_of_file(*named, bundle);
  }
  if (document.contains("model")) {
    read_model(document["model"], source, bundle);
  }
  if (document.contains("band_hz")) {
    bundle.band_hz = read_band(document["band_hz"], source);
  }
  if (document.contains("weighed")) {
    bundle.weighed = read_weighed(document["weighed"]);
  }
  if (document.contains("suspension_hz")) {
    bundle.suspension_hz = document["suspension_hz"].get<double>();
  }
  if (document.contains("uncertain")) {
    const json& list = document["uncertain"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      bundle.uncertain.push_back(
          read_uncertain(list[i], fmt::format("uncertain[{}]", i), source));
    }
  }
  for (const std::string& place : unknown_fields(document)) {
    bundle.warnings.push_back(
        fmt::format("{}: unknown field, not used", source.at(place)));
  }
  if (auto note = unplaced_note(bundle)) {
    bundle.warnings.push_back(*std::move(note));
  }
  for (std::string& lossy : lossy_statements(bundle)) {
    bundle.warnings.push_back(std::move(lossy));
  }
  return bundle;
}

}  // namespace tapfit::acquisition
