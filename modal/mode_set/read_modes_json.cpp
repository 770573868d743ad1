#include "modal/mode_set/read_modes_json.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parse_json.hpp"
#include "modal/mode_set/complexity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string_view>

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

/// The text with null for the NaN and Infinity that Python writes and JSON does
/// not know.
std::string not_finite_as_null(const std::string& text) {
  std::string result;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool escaped = quoted && text[at] == '\\' && at + 1 < text.size();
    if (text[at] == '"') quoted = !quoted;
    std::size_t length = 0;
    for (const std::string_view word : {"NaN", "-Infinity", "Infinity"}) {
      const bool here = !quoted && text.compare(at, word.size(), word) == 0;
      if (here) length = word.size();
    }
    result += length > 0 ? "null" : text.substr(at, escaped ? 2 : 1);
    at += length > 0 ? length - 1 : static_cast<std::size_t>(escaped);
  }
  return result;
}

std::string place_of(std::size_t mode, const std::string& name) {
  return fmt::format("{}: modes[{}]", name, mode);
}

/// All points of the modes, in order.
Rows take_points(const json& modes, const std::string& name) {
  Rows rows;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const json shape = modes[k].value("shape", json::object());
    const std::string place = place_of(k, name) + ".shape";
    if (!shape.is_object()) {
      throw InputError("it is no object of points and their values",
                       place,
                       "write {\"12Z+\": 0.5, \"13Z+\": [0.4, 0.01]}");
    }
    for (const auto& [text, value] : shape.items()) {
      Dof dof = point_named(text, place);
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
    const auto row = rows.find(point);
    if (row == rows.end()) {
      throw InputError(fmt::format("{} is no point of the shapes", text),
                       place,
                       "give standard deviations where shapes have values");
    }
    result(row->second) = read(value, sign, place + "." + text);
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

[[noreturn]] void refuse_value(const json& value, const std::string& place) {
  throw InputError(
      value.is_null() ? "the value is null, or NaN"
                      : fmt::format("{} is no number", value.dump()),
      place,
      "write a number, or [real, imaginary] in a shape; where it is not known, "
      "leave the point out of all modes, or the mode out");
}

std::complex<double> complex_value(const json& value,
                                   int sign,
                                   const std::string& place) {
  const auto turned = static_cast<double>(sign);
  if (value.is_number()) return value.get<double>() * turned;
  const bool pair = value.is_array() && value.size() == 2 &&
                    value[0].is_number() && value[1].is_number();
  if (!pair) refuse_value(value, place);
  return std::complex<double>(value[0], value[1]) * turned;
}

double deviation_value(const json& value, int, const std::string& place) {
  if (!value.is_number()) refuse_value(value, place);
  return value.get<double>();
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
      said.is_null() ? "it is missing, null or NaN"
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
    mode.shape_sd = values<double>(
        entry.at("shape_sd"), rows, place + ".shape_sd", deviation_value);
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
    const json all = parse_json(not_finite_as_null(text), name);
    const json modes = list_of_modes(all, name);
    const Rows rows = take_points(modes, name);
    for (const auto& [dof, row] : rows) set.dofs.push_back(dof);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      set.modes.push_back(take_mode(modes[k], rows, place_of(k, name)));
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
