#include "acquisition/bundle/read_placement.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/model_units.hpp"
#include "acquisition/foundation/named_axes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <optional>

namespace tapfit::acquisition {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

Vector3d vector_of(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

std::size_t find_channel(const std::vector<Channel>& channels,
                         const std::string& name,
                         const std::string& where) {
  std::string known;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == name) return i;
    known += (i == 0 ? "" : ", ") + channels[i].name;
  }
  throw InputError(fmt::format("no channel is called \"{}\"", name),
                   where,
                   "use one of " + known);
}

// A letter as a degree of freedom of a node.
Dof read_letter(const std::string& text, int node, const std::string& where) {
  const std::optional<Dof> dof = parse_direction(node, text);
  if (dof && dof->component <= 3) return *dof;
  throw InputError(fmt::format("\"{}\" is no direction", text),
                   where,
                   "use +X, -X, +Y, -Y, +Z or -Z, or a vector such as [0.6, 0, "
                   "0.8]");
}

Vector3d unit_of(const Dof& dof) {
  return dof.sign * Vector3d::Unit(dof.component - 1);
}

// Of unit length, in the axes of `system`.
struct Direction {
  Vector3d along;
  int system = 0;
};

Direction read_direction(const json& said, const std::string& where) {
  if (said.is_string()) {
    return {unit_of(read_letter(said.get<std::string>(), 0, where))};
  }
  if (said.is_object()) {
    const std::string axis = said.at("axis").get<std::string>();
    return {unit_of(read_letter(axis, 0, where + ".axis")),
            said.at("system").get<int>()};
  }
  const Vector3d along = vector_of(said);
  const double length = along.norm();
  if (length > 1e-100 && length < 1e100) return {along / length};
  throw InputError(
      fmt::format("the direction {} has no length", said.dump()),
      where,
      "give the way the sensor or blow points, [0.6, 0, 0.8] for example; its "
      "length does not count");
}

// Labels that a test's geometry has are taken.
int first_label(const TestBundle& bundle) {
  if (!bundle.geometry || bundle.geometry->nodes.empty()) return 1;
  return bundle.geometry->nodes.rbegin()->first + 1;
}

}  // namespace

struct PlacementReader::Site {
  TestPoint point;
  bool at_coordinates = false;
};

PlacementReader::PlacementReader(const TestBundle& bundle,
                                 const JsonSource& source)
    : bundle_(&bundle), source_(&source), table_(first_label(bundle)) {}

PlacementReader::Site PlacementReader::read_site(
    const json& entry, const std::string& place) const {
  Site site;
  site.point.place = source_->at(place);
  if (entry.contains("at") == entry.contains("node")) {
    throw InputError("says no place on the structure, or two",
                     source_->at(place),
                     "give either at, three coordinates, or node, a grid");
  }
  if (entry.contains("node")) {
    site.point.node = entry["node"].get<int>();
    return site;
  }
  site.at_coordinates = true;
  site.point.at = vector_of(entry["at"]) * model_units(bundle_->units)->length;
  return site;
}

// A node of the test's geometry: along its own axes, or any other direction.
Dof PlacementReader::at_test_node(const Site& site,
                                  const json& direction,
                                  const std::string& place) {
  const TestGeometry& geometry = *bundle_->geometry;
  const int label = site.point.node;
  if (!geometry.nodes.contains(label)) {
    throw InputError(
        fmt::format("the test's geometry has no point {}", label),
        source_->at(place),
        fmt::format("use a label of {}, or give at, coordinates on the model",
                    geometry.file.filename().string()));
  }
  Direction said = read_direction(direction, source_->at(place + ".direction"));
  const auto own = geometry.directions.find(label);
  if (direction.is_string() && own != geometry.directions.end()) {
    said.along = own->second * said.along;
  }
  TestPoint point = own_point(geometry, label);
  if (site.point.height_m == 0.0 && said.system == 0) {
    if (const auto named = along_one_of(point.axes, said.along)) {
      table_.keep(point);
      return {-label, named->component, named->sign};
    }
  }
  point.place = site.point.place;
  point.height_m = site.point.height_m;
  point.system = said.system;
  return table_.add(point, said.along);
}

Dof PlacementReader::read_dof(const json& entry,
                              const std::string& place,
                              double height_m) {
  Site site = read_site(entry, place);
  site.point.height_m = entry.value("height_m", height_m);
  const json& direction = entry.at("direction");
  if (bundle_->geometry && !site.at_coordinates) {
    return at_test_node(site, direction, place);
  }
  const Direction along =
      read_direction(direction, source_->at(place + ".direction"));
  site.point.system = along.system;
  const bool at_grid = !site.at_coordinates && site.point.height_m == 0.0;
  if (at_grid && along.system == 0) {
    const auto basic = along_one_of(Eigen::Matrix3d::Identity(), along.along);
    if (basic) return {site.point.node, basic->component, basic->sign};
  }
  return table_.add(site.point, along.along);
}

Placement PlacementReader::read(const json& entry, const std::string& place) {
  Placement placement;
  placement.channel = find_channel(bundle_->channels,
                                   entry.at("channel").get<std::string>(),
                                   source_->at(place + ".channel"));
  const double height = bundle_->channels[placement.channel].height_m;
  if (entry.contains("point") && entry["point"].is_object()) {
    placement.dof = read_dof(entry["point"], place + ".point", height);
    return placement;
  }
  json said = entry;
  if (entry.contains("point")) {
    const std::string text = entry["point"].get<std::string>();
    const std::optional<Dof> dof = parse_dof(text);
    if (!dof || dof->component > 3 || dof->node < 1) {
      throw InputError(fmt::format("\"{}\" is no point", text),
                       source_->at(place + ".point"),
                       "write grid and direction as in \"3:+Z\"");
    }
    said = {{"node", dof->node},
            {"direction", name(*dof).substr(std::to_string(dof->node).size())}};
  } else if (!entry.contains("node") || !entry.contains("direction")) {
    throw InputError(
        "says no place on the structure",
        source_->at(place),
        "give node and direction, or point as in \"3:+Z\" or {\"at\": "
        "[0.1, 0.2, 0], \"direction\": [0, 0, 1]}");
  }
  placement.dof = read_dof(said, place, height);
  return placement;
}

}  // namespace tapfit::acquisition
