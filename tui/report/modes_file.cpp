#include "tui/report/modes_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/read_modes_uff.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <system_error>

namespace tapfit::tui {
namespace {

using nlohmann::json;

/// All points of the modes, in order.
std::map<Dof, Eigen::Index> take_points(const json& modes,
                                        const std::string& name) {
  std::map<Dof, Eigen::Index> rows;
  for (const json& entry : modes) {
    for (const auto& [text, value] : entry.at("shape").items()) {
      std::optional<Dof> dof = parse_dof(text);
      if (!dof) {
        throw InputError("\"" + text + "\" is no point",
                         name + ": shape",
                         "write grid and direction, such as 12Z+");
      }
      dof->sign = 1;
      rows[*dof] = 0;
    }
  }
  Eigen::Index next = 0;
  for (auto& [dof, row] : rows) row = next++;
  return rows;
}

/// The values at the rows; points of sign -1 are turned.
template <typename Value, typename Read>
Eigen::Matrix<Value, Eigen::Dynamic, 1> values(
    const json& entry, const std::map<Dof, Eigen::Index>& rows, Read read) {
  Eigen::Matrix<Value, Eigen::Dynamic, 1> result =
      Eigen::Matrix<Value, Eigen::Dynamic, 1>::Zero(
          static_cast<Eigen::Index>(rows.size()));
  for (const auto& [text, value] : entry.items()) {
    Dof point = *parse_dof(text);
    const int sign = point.sign;
    point.sign = 1;
    result(rows.at(point)) = read(value, sign);
  }
  return result;
}

modal::Mode take_mode(const json& entry,
                      const std::map<Dof, Eigen::Index>& rows) {
  modal::Mode mode;
  mode.frequency_hz = entry.at("frequency_hz").at("value");
  mode.frequency_sd_hz = entry.at("frequency_hz").value("sd", 0.0);
  mode.damping_ratio = entry.at("damping_ratio").at("value");
  mode.damping_sd = entry.at("damping_ratio").value("sd", 0.0);
  const double omega = 2.0 * std::numbers::pi * mode.frequency_hz;
  const double zeta = mode.damping_ratio;
  mode.pole = {-zeta * omega,
               omega * std::sqrt(std::max(0.0, 1.0 - zeta * zeta))};
  mode.shape = values<std::complex<double>>(
      entry.at("shape"), rows, [](const json& value, int sign) {
        return std::complex<double>(value.at(0), value.at(1)) * double(sign);
      });
  if (entry.contains("shape_sd")) {
    mode.shape_sd =
        values<double>(entry.at("shape_sd"), rows, [](const json& value, int) {
          return value.get<double>();
        });
  }
  mode.mpc = modal::phase_collinearity(mode.shape);
  mode.mpd_deg = modal::mean_phase_deviation(mode.shape);
  return mode;
}

}  // namespace

modal::ModeSet read_modes_json(const std::string& text,
                               const std::string& name) {
  modal::ModeSet set;
  try {
    const json all = json::parse(text);
    const std::map<Dof, Eigen::Index> rows = take_points(all.at("modes"), name);
    for (const auto& [dof, row] : rows) set.dofs.push_back(dof);
    for (const json& entry : all.at("modes")) {
      set.modes.push_back(take_mode(entry, rows));
    }
    set.scaled = all.value("unit_modal_mass", false);
  } catch (const json::exception& error) {
    throw InputError(
        fmt::format("not the JSON of identified modes ({})", error.what()),
        name,
        "write it with tapfit modes BUNDLE --json");
  }
  if (set.modes.empty()) {
    throw InputError("no mode in the file", name, "identify modes first");
  }
  return set;
}

modal::ModeSet read_modes_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError("is a folder, not a file of modes",
                     file.string(),
                     "write one with tapfit modes BUNDLE --json > modes.json");
  }
  if (file.extension() != ".json") return modal::read_modes_uff(file).set;
  std::ifstream in =
      acquisition::open_input(file, acquisition::most_text_bytes);
  if (!in) {
    throw InputError("cannot be read", file.string(), "check its name");
  }
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return read_modes_json(text, file.string());
}

}  // namespace tapfit::tui
