#include "acquisition/bundle/write_test_bundle.hpp"

#include "acquisition/foundation/model_units.hpp"
#include "acquisition/foundation/units.hpp"

#include <nlohmann/json.hpp>


namespace tapfit::acquisition {
namespace {

using ordered_json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string path_text(const fs::path& file, const fs::path& folder) {
  if (!file.has_parent_path()) return file.generic_string();
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path base = fs::absolute(folder).lexically_normal();
  const fs::path relative = whole.lexically_relative(base);
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return (inside ? relative : whole).generic_string();
}

ordered_json channel_json(const Channel& channel) {
  const bool compound = channel.unit.find('/') != std::string::npos;
  ordered_json entry = {
      {"name", channel.name},
      {"quantity", name(channel.quantity)},
      {"unit", channel.unit},
      {"sensitivity", channel.sensitivity},
      {"sensitivity_unit",
       compound ? "V/(" + channel.unit + ")" : "V/" + channel.unit},
      {"full_scale_volts", channel.full_scale_volts},
  };
  if (channel.mass_kg) entry["mass_kg"] = *channel.mass_kg;
  if (channel.height_m != 0.0) entry["height_m"] = channel.height_m;
  return entry;
}

// A component of a point of the test's own.
ordered_json point_json(const Dof& dof, const TestBundle& bundle) {
  const TestPoint* point = find_point(bundle.points, -dof.node);
  if (point == nullptr) return name(dof);
  const Eigen::Vector3d along = dof.sign * point->axes.col(dof.component - 1);
  ordered_json said = ordered_json::object();
  if (point->of_node != 0) {
    said["node"] = point->of_node;
  } else if (point->node != 0) {
    said["node"] = point->node;
  } else {
    const Eigen::Vector3d at = *point->at / model_units(bundle.units)->length;
    said["at"] = {at.x(), at.y(), at.z()};
  }
  if (point->system != 0) {
    said["direction"] = {
        {"system", point->system},
        {"axis",
         std::string(dof.sign < 0 ? "-" : "+") + "XYZ"[dof.component - 1]}};
  } else {
    said["direction"] = {along.x(), along.y(), along.z()};
  }
  said["height_m"] = point->height_m;
  return said;
}

ordered_json placement_json(const Placement& placement,
                            const TestBundle& bundle) {
  if (placement.dof.node < 0) {
    return {{"channel", bundle.channels.at(placement.channel).name},
            {"point", point_json(placement.dof, bundle)}};
  }
  const std::string direction =
      std::string(placement.dof.sign < 0 ? "-" : "+") +
      "XYZ"[(placement.dof.component - 1) % 3];
  return {{"channel", bundle.channels.at(placement.channel).name},
          {"node", placement.dof.node},
          {"direction", direction}};
}

ordered_json runs_json(const TestBundle& bundle, const fs::path& folder) {
  ordered_json runs = ordered_json::array();
  for (const Run& run : bundle.runs) {
    ordered_json sensors = ordered_json::array();
    for (const Placement& sensor : run.sensors) {
      sensors.push_back(placement_json(sensor, bundle));
    }
    runs.push_back({{"file", path_text(run.file, folder)},
                    {"hammer", placement_json(run.hammer, bundle)},
                    {"sensors", sensors}});
  }
  return runs;
}

void add_model(const TestBundle& bundle,
               const fs::path& folder,
               ordered_json& document) {
  if (bundle.deck) document["model"] = path_text(*bundle.deck, folder);
  if (!bundle.matrices) return;
  document["model"] = {
      {"stiffness", path_text(bundle.matrices->stiffness, folder)},
      {"mass", path_text(bundle.matrices->mass, folder)},
      {"dofs", path_text(bundle.matrices->dofs, folder)}};
}

void add_geometry(const TestBundle& bundle,
                  const fs::path& folder,
                  ordered_json& document) {
  if (!bundle.geometry) return;
  const double length = model_units(bundle.units)->length;
  ordered_json& geometry = document["geometry"];
  geometry["file"] = path_text(bundle.geometry->file, folder);
  for (const NamedPair& pair : bundle.geometry->pairs) {
    const Eigen::Vector3d at = pair.at / length;
    geometry["pairs"].push_back(
        pair.grid != 0 ? ordered_json{pair.label, pair.grid}
                       : ordered_json{pair.label, {at.x(), at.y(), at.z()}});
  }
}

void add_settings(const TestBundle& bundle, ordered_json& document) {
  if (bundle.band_hz) document["band_hz"] = *bundle.band_hz;
  if (bundle.weighed) {
    document["weighed"] = {{"mass_kg", bundle.weighed->mass_kg},
                           {"sd_percent", bundle.weighed->sd_percent}};
    if (bundle.weighed->centre_m) {
      document["weighed"]["centre_m"] = *bundle.weighed->centre_m;
    }
  }
  if (bundle.suspension_hz) document["suspension_hz"] = *bundle.suspension_hz;
  if (bundle.trigger_percent) {
    document["trigger_percent"] = *bundle.trigger_percent;
  }
  const TriggerOptions& trigger = bundle.trigger;
  if (trigger.range_percent) {
    document["trigger_range_percent"] = *trigger.range_percent;
  }
  if (trigger.slope) {
    document["trigger_slope"] = *trigger.slope < 0 ? "falling" : "rising";
  }
  if (trigger.rearm_percent) {
    document["trigger_rearm_percent"] = *trigger.rearm_percent;
  }
  if (trigger.hold_off_s) document["hold_off_s"] = *trigger.hold_off_s;
  if (bundle.pre_trigger_s) document["pre_trigger_s"] = *bundle.pre_trigger_s;
  if (bundle.block_s) document["block_s"] = *bundle.block_s;
  for (const UncertainProperty& entry : bundle.uncertain) {
    const char* key =
        entry.card == "material" ? "material" : "element_property";
    document["uncertain"].push_back({{key, entry.id},
                                     {"property", entry.property},
                                     {"sd_percent", entry.sd_percent}});
  }
}

}  // namespace

std::string test_bundle_text(const TestBundle& bundle, const fs::path& folder) {
  ordered_json document = {{"tapfit", 1}};
  if (!bundle.title.empty()) document["title"] = bundle.title;
  if (bundle.units != "SI") document["units"] = bundle.units;
  if (!bundle.ignored_cards.empty()) {
    document["ignore_cards"] = bundle.ignored_cards;
  }
  add_model(bundle, folder, document);
  add_geometry(bundle, folder, document);
  for (const Channel& channel : bundle.channels) {
    document["channels"].push_back(channel_json(channel));
  }
  if (!bundle.runs.empty()) document["runs"] = runs_json(bundle, folder);
  if (bundle.frfs) document["frfs"] = path_text(*bundle.frfs, folder);
  if (bundle.modes) {
    document["modes"] = {
        {"file", path_text(bundle.modes->file, folder)},
        {"frequency_sd_percent", bundle.modes->frequency_sd_percent},
        {"shape_sd_percent", bundle.modes->shape_sd_percent}};
  }
  add_settings(bundle, document);
  return document.dump(1) + '\n';
}

}  // namespace tapfit::acquisition
