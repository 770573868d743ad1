#include "acquisition/bundle/read_test_geometry.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/bundle/uff_points.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/model_units.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <system_error>

namespace tapfit::acquisition {
namespace {

using nlohmann::json;

NamedPair read_pair(const json& entry,
                    double length,
                    const std::string& where) {
  const bool coordinates = entry[1].is_array() && entry[1].size() == 3 &&
                           std::ranges::all_of(entry[1], [](const json& x) {
                             return x.is_number();
                           });
  if (!entry[0].is_number_integer() ||
      !(coordinates || entry[1].is_number_integer())) {
    throw InputError(fmt::format("{} is no pair", entry.dump()),
                     where,
                     "write [point of the test, grid of the model] or [point, "
                     "[x, y, z]]");
  }
  NamedPair pair{entry[0].get<int>()};
  if (coordinates) {
    for (int i = 0; i < 3; ++i) {
      pair.at(i) = length * entry[1][static_cast<std::size_t>(i)].get<double>();
    }
  } else {
    pair.grid = entry[1].get<int>();
  }
  return pair;
}

std::filesystem::path file_of(const json& entry,
                              const TestBundle& bundle,
                              const JsonSource& source) {
  if (!entry.contains("file")) {
    if (const auto file = points_file(bundle)) return *file;
    throw InputError("names no file",
                     source.at("geometry"),
                     "name the universal file (or the table label, x, y, z) "
                     "that holds the test's points in \"file\"");
  }
  std::filesystem::path file = source.folder / entry["file"].get<std::string>();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) return file;
  throw InputError(no_file(file),
                   source.at("geometry.file"),
                   "correct the path; it is relative to test.json's folder");
}

}  // namespace

TestGeometry read_test_geometry(const json& entry,
                                const TestBundle& bundle,
                                const JsonSource& source) {
  const double length = model_units(bundle.units)->length;
  TestGeometry geometry =
      read_geometry_file(file_of(entry, bundle, source), length);
  const auto of = points_file(bundle);
  const bool apart = of && geometry.file != *of;
  if (apart && is_uff(*of)) take_directions(*of, geometry);
  if (!entry.contains("pairs")) return geometry;
  std::set<int> labels;
  for (std::size_t k = 0; k < entry["pairs"].size(); ++k) {
    const std::string where = source.at(fmt::format("geometry.pairs[{}]", k));
    const NamedPair pair = read_pair(entry["pairs"][k], length, where);
    if (!geometry.nodes.contains(pair.label)) {
      throw InputError(fmt::format("{} has no point {}",
                                   geometry.file.filename().string(),
                                   pair.label),
                       where,
                       "name a point of the test first, then a grid");
    }
    if (!labels.insert(pair.label).second) {
      throw InputError(fmt::format("point {} has a pair already", pair.label),
                       where,
                       "name each point once");
    }
    geometry.pairs.push_back(pair);
  }
  return geometry;
}

std::optional<std::filesystem::path> points_file(const TestBundle& bundle) {
  if (bundle.frfs) return bundle.frfs;
  if (bundle.modes) return bundle.modes->file;
  return std::nullopt;
}

std::vector<TestPoint> points_of_file(const std::filesystem::path& path,
                                      const TestBundle& bundle) {
  const std::string name = path.filename().string();
  if (bundle.geometry) {
    std::vector<TestPoint> points;
    for (const auto& [label, unused] : bundle.geometry->nodes) {
      points.push_back(own_point(*bundle.geometry, label));
    }
    return points;
  }
  if (!is_uff(path)) return {};
  const UffFile file = open_uff(path);
  return file.bytes.reading(
      [&] { return own_points(read_uff_mesh(file.datasets), name); });
}

}  // namespace tapfit::acquisition
