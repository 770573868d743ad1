#include "tui/commands/compare_command.hpp"

#include "tui/commands/commands.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/point_places.hpp"
#include "tui/report/report_words.hpp"
#include "tui/report/text_table.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t worst_shown = 5;

/// By name; of several runs of one pair the worse.
/// @param worse of two values
template <class Worse>
ordered_json by_frf_json(const std::vector<double>& values,
                         const signal::FrfSet& frfs,
                         const Worse& worse) {
  ordered_json json = ordered_json::object();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string key = name(frfs.frfs.at(k));
    json[key] = worse(values[k], json.value(key, values[k]));
  }
  return json;
}

ordered_json frac_json(const updating::Comparison& comparison,
                       const signal::FrfSet& frfs) {
  return by_frf_json(comparison.frac, frfs, std::ranges::min);
}

ordered_json frf_error_json(const updating::Comparison& comparison,
                            const signal::FrfSet& frfs) {
  return by_frf_json(comparison.frf_error, frfs, std::ranges::max);
}

ordered_json bands_json(const updating::Comparison& comparison) {
  ordered_json bands = ordered_json::array();
  for (const auto& band : comparison.bands) {
    bands.push_back({{"low_hz", band.low_hz},
                     {"high_hz", band.high_hz},
                     {"error", band.error}});
  }
  return bands;
}

bool has_comac(const updating::Comparison& comparison,
               const std::vector<Dof>& dofs) {
  return !comparison.pairs.empty() &&
         comparison.comac.size() == static_cast<Eigen::Index>(dofs.size());
}

ordered_json comac_json(const updating::Comparison& comparison,
                        const std::vector<Dof>& dofs) {
  ordered_json comac = ordered_json::object();
  if (!has_comac(comparison, dofs)) return comac;
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    comac[name(dofs[k])] = comparison.comac(static_cast<Eigen::Index>(k));
  }
  return comac;
}

/// "  CoMAC at worst 0.871 at 12Z+, 0.902 at 3Z+".
std::string comac_text(const updating::Comparison& comparison,
                       const std::vector<Dof>& dofs) {
  if (!has_comac(comparison, dofs) || dofs.empty()) return {};
  std::vector<std::size_t> order(dofs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto comac = [&comparison](std::size_t k) {
    return comparison.comac(static_cast<Eigen::Index>(k));
  };
  std::ranges::sort(order, std::less{}, comac);
  std::string text = "  CoMAC at worst";
  for (std::size_t k = 0; k < std::min<std::size_t>(3, order.size()); ++k) {
    text += fmt::format("{} {:.3f} at {}",
                        k == 0 ? "" : ",",
                        comac(order[k]),
                        name(dofs[order[k]]));
  }
  return text + "\n";
}

std::string worst_frfs_text(const updating::Comparison& comparison,
                            const signal::FrfSet& frfs) {
  if (comparison.frf_error.empty()) return {};
  std::vector<std::size_t> order(comparison.frf_error.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, std::greater{}, [&](std::size_t k) {
    return comparison.frf_error[k];
  });
  TextTable table({"<worst FRFs", "run", "error", "FRAC"});
  for (std::size_t k : order) {
    if (k == order[std::min(worst_shown, order.size() - 1)] &&
        order.size() > worst_shown) {
      break;
    }
    const auto& frf = frfs.frfs.at(k);
    table.add({name(frf),
               fmt::format("{}", frf.run + 1),
               percent(comparison.frf_error[k]),
               fmt::format("{:.3f}", comparison.frac.at(k))});
  }
  return table.text();
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "  note: " + note + "\n";
  return text;
}

std::string bands_text(const updating::Comparison& comparison) {
  if (comparison.bands.empty()) return {};
  TextTable table({"<band Hz", "error"});
  for (const auto& band : comparison.bands) {
    table.add({fmt::format("{:.4g} to {:.4g}", band.low_hz, band.high_hz),
               percent(band.error)});
  }
  return table.text();
}

}  // namespace

namespace {

/// Row by row: measured modes x modes of the model.
ordered_json matrix_json(const Eigen::MatrixXd& matrix) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back(
        std::vector<double>(matrix.row(i).begin(), matrix.row(i).end()));
  }
  return rows;
}

}  // namespace

ordered_json compare_json(const updating::Comparison& comparison,
                          const signal::FrfSet& frfs,
                          const std::vector<Dof>& dofs) {
  ordered_json pairs = ordered_json::array();
  for (const auto& pair : comparison.pairs) {
    pairs.push_back({{"measured_hz", pair.measured_hz},
                     {"model_hz", pair.model_hz},
                     {"error_percent", pair.error_percent},
                     {"mac", pair.mac},
                     {"weighted_mac", pair.weighted_mac},
                     {"by_hand", pair.by_hand}});
    if (pair.has_shape) continue;
    pairs.back()["mac"] = nullptr;
    pairs.back()["weighted_mac"] = nullptr;
  }
  ordered_json points = ordered_json::object();
  for (const auto& [node, error] : comparison.point_error) {
    points[node_name(node)] = error;
  }
  return {{"error",
           {{"base", comparison.error},
            {"floor", comparison.floor},
            {"floor_noise", comparison.floor_noise},
            {"floor_mesh", comparison.floor_mesh},
            {"floor_form", comparison.floor_form},
            {"contour", comparison.contour}}},
          {"pairs", std::move(pairs)},
          {"pair_notes", comparison.pair_notes},
          {"mac", matrix_json(comparison.mac)},
          {"weighted_mac", matrix_json(comparison.weighted_mac)},
          {"frac", frac_json(comparison, frfs)},
          {"comac", comac_json(comparison, dofs)},
          {"points", std::move(points)},
          {"bands", bands_json(comparison)},
          {"frf_error", frf_error_json(comparison, frfs)}};
}

std::string pairs_text(const std::vector<updating::ModePair>& pairs) {
  TextTable table(
      {"mode", "measured Hz", "model Hz", "error", "MAC", "in mass", "<"});
  for (const auto& pair : pairs) {
    table.add({fmt::format("{}", pair.measured + 1),
               fmt::format("{:.3f}", pair.measured_hz),
               fmt::format("{:.3f}", pair.model_hz),
               fmt::format("{:+.2f} %", pair.error_percent),
               pair.has_shape ? fmt::format("{:.3f}", pair.mac) : "-",
               pair.has_shape ? fmt::format("{:.3f}", pair.weighted_mac) : "-",
               pair.by_hand ? "by hand" : ""});
  }
  return table.text();
}

std::string compare_text(const updating::Comparison& comparison,
                         const signal::FrfSet& frfs,
                         const std::vector<Dof>& dofs) {
  return fmt::format(
             "Model against measurement: error {}, floor {} "
             "({})\n  {}\n",
             percent(comparison.error),
             percent(comparison.floor),
             floor_words(comparison),
             on_contour(comparison.contour)) +
         pairs_text(comparison.pairs) + comac_text(comparison, dofs) +
         notes_text(comparison.pair_notes) + bands_text(comparison) +
         worst_frfs_text(comparison, frfs);
}

std::string compare_command(const CommandOptions& options,
                            const Progress& progress) {
  updating::Session session = open_by_hand(options, progress);
  const updating::Comparison& comparison = session.base_comparison(progress);
  const signal::FrfSet& frfs = session.frfs(progress);
  const std::vector<Dof>& dofs = session.modes(progress).dofs;
  const std::vector<std::string> warnings = session.model_warnings(progress);
  if (options.json) {
    ordered_json json = compare_json(comparison, frfs, dofs);
    json["reduced_base_error"] = session.base_error(progress);
    add_point_places(session.deck(progress), json);
    json["warnings"] = warnings;
    return json_text(json);
  }
  std::string text = compare_text(comparison, frfs, dofs);
  if (!session.bundle().modes) {
    text += fmt::format("  the model's FRFs are exact to {:.0e}\n",
                        std::max(session.base_error(progress), 1e-15));
  }
  return text + point_places_text(session.deck(progress)) +
         notes_text(warnings);
}

}  // namespace tapfit::tui
