#include "modal/mode_set/read_modes_json.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parse_json.hpp"
#include "modal/mode_set/complexity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace tapfit::modal {
namespace {

using nlohmann::json;
using Rows = std::map<Dof, Eigen::Index>;

Dof point_named(const std::string& text, const std::string& place) {
  const std::optional<Dof> dof = parse_dof(text);
  if (dof) return *dof;
  throw InputError("\"" + text + "\" is no point",
                   place,
                   "write grid and direction, such as 12Z+");
}

/// All points of the modes, in order.
Rows take_points(const json& modes, const std::string& name) {
  Rows rows;
  for (const json& entry : modes) {
    if (!entry.contains("shape")) continue;
    for (const auto& [text, value] : entry.at("shape").items()) {
      Dof dof = point_named(text, name + ": shape");
      dof.sign = 1;
      rows[dof] = 0;
    }
  }
  Eigen::Index next = 0;
  for (auto& [dof, row] : rows) row = next++;
  return rows;
}

/// The values at the rows; points of sign -1 are turned.
template <typename Value, typename Read>
Eigen::Matrix<Value, Eigen::Dynamic, 1> values(const json& entry,
                                               const Rows& rows,
                                               const std::string& place,
                                               Read read) {
  Eigen::Matrix<Value, Eigen::Dynamic, 1> result(
      static_cast<Eigen::Index>(rows.size()));
  Rows missing = rows;
  for (const auto& [text, value] : entry.items()) {
    Dof point = point_named(text, place);
    const int sign = point.sign;
    point.sign = 1;
    result(rows.at(point)) = read(value, sign);
    if (missing.erase(point) > 0) continue;
    throw InputError(
        fmt::format("there are two values at {}", tapfit::name(point)),
        place,
        "leave one of the two out: 12Z+ and 12Z- are one point");
  }
  if (missing.empty()) return result;
  throw InputError(
      fmt::format("there is no value at {}",
                  tapfit::name(missing.begin()->first)),
      place,
      "give every mode a value at every point, or leave the point out of all");
}

std::complex<double> complex_value(const json& value, int sign) {
  const auto turned = static_cast<double>(sign);
  if (value.is_number()) return value.get<double>() * turned;
  return std::complex<double>(value.at(0), value.at(1)) * turned;
}

/// Of {"value": .., "sd": ..} or of a number; null is what is not known.
struct Said {
  double value = 0.0;
  double sd = 0.0;
};

Said number_at(const json& entry,
               const std::string& key,
               const std::string& place) {
  const json said = entry.value(key, json());
  if (said.is_number()) return {said.get<double>()};
  const json value = said.is_object() ? said.value("value", json()) : json();
  const json sd = said.is_object() ? said.value("sd", json()) : json();
  if (value.is_number() && (sd.is_number() || sd.is_null())) {
    return {value.get<double>(), sd.is_number() ? sd.get<double>() : 0.0};
  }
  throw InputError(
      said.is_null() ? "it is missing"
                     : fmt::format("{} is no number", said.dump()),
      place + "." + key,
      fmt::format("write \"{0}\": 8.2 or \"{0}\": {{\"value\": 8.2, "
                  "\"sd\": 0.01}}",
                  key));
}

bool is_known(const json& entry, const std::string& key) {
  const json said = entry.value(key, json());
  return !said.is_null() &&
         !(said.is_object() && said.value("value", json(0.0)).is_null());
}

Mode take_mode(const json& entry, const Rows& rows, const std::string& place) {
  Mode mode;
  const Said frequency = number_at(entry, "frequency_hz", place);
  const Said damping = is_known(entry, "damping_ratio")
                           ? number_at(entry, "damping_ratio", place)
                           : Said{};
  mode.frequency_sd_hz = frequency.sd;
  mode.damping_sd = damping.sd;
  set_pole(mode, frequency.value, damping.value);
  mode.shape =
      values<std::complex<double>>(entry.value("shape", json::object()),
                                   rows,
                                   place + ".shape",
                                   complex_value);
  if (entry.contains("shape_sd")) {
    mode.shape_sd =
        values<double>(entry.at("shape_sd"),
                       rows,
                       place + ".shape_sd",
                       [](const json& v, int) { return v.get<double>(); });
  }
  mode.mpc = phase_collinearity(mode.shape);
  mode.mpd_deg = mean_phase_deviation(mode.shape);
  return mode;
}

/// The list of modes, each an object.
json list_of_modes(const json& all, const std::string& name) {
  const json modes = all.is_object() ? all.value("modes", json()) : json();
  const bool list =
      modes.is_array() && std::ranges::all_of(modes, [](const json& mode) {
        return mode.is_object();
      });
  if (list) return modes;
  throw InputError("it holds no list of modes",
                   name,
                   "write {\"modes\": [{\"frequency_hz\": 8.2, \"shape\": "
                   "{\"12Z+\": 0.5}}]}, as tapfit modes BUNDLE --json does");
}

}  // namespace

ModeSet read_modes_json(const std::string& text, const std::string& name) {
  ModeSet set;
  try {
    const json all = parse_json(text, name);
    const json modes = list_of_modes(all, name);
    const Rows rows = take_points(modes, name);
    for (const auto& [dof, row] : rows) set.dofs.push_back(dof);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      set.modes.push_back(
          take_mode(modes[k], rows, fmt::format("{}: modes[{}]", name, k)));
    }
    set.scaled = all.value("unit_modal_mass", false);
  } catch (const json::exception& error) {
    throw InputError(
        fmt::format("not the JSON of identified modes ({})", error.what()),
        name,
        "write it as tapfit modes BUNDLE --json does");
  }
  if (set.modes.empty()) {
    throw InputError("no mode in the file", name, "identify modes first");
  }
  std::ranges::stable_sort(set.modes, {}, &Mode::frequency_hz);
  return set;
}

}  // namespace tapfit::modal
