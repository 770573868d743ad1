#include "tui/commands/mac_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/read_modes_file.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "tui/workbench/pair_words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

constexpr Eigen::Index kMaccoSteps = 5;

/// Shapes of both sets at the points that they share.
struct Common {
  std::vector<Dof> dofs;
  Eigen::MatrixXcd first;
  Eigen::MatrixXcd second;
  /// Not finite where the file does not tell.
  Eigen::MatrixXd first_sd;
  std::vector<modal::Pair> pairs;
};

Eigen::MatrixXcd rows_of(const modal::ModeSet& set,
                         const std::vector<Eigen::Index>& rows) {
  Eigen::MatrixXcd shapes(static_cast<Eigen::Index>(rows.size()),
                          static_cast<Eigen::Index>(set.modes.size()));
  for (std::size_t k = 0; k < set.modes.size(); ++k) {
    shapes.col(static_cast<Eigen::Index>(k)) = set.modes[k].shape(rows);
  }
  return shapes;
}

Eigen::VectorXd frequencies(const modal::ModeSet& set) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(set.modes.size()));
  for (std::size_t k = 0; k < set.modes.size(); ++k) {
    f(static_cast<Eigen::Index>(k)) = set.modes[k].frequency_hz;
  }
  return f;
}

Common common_points(const modal::ModeSet& first,
                     const modal::ModeSet& second,
                     const std::vector<modal::Pair>& by_hand) {
  Common common;
  std::vector<Eigen::Index> rows;
  std::vector<Eigen::Index> others;
  for (std::size_t k = 0; k < first.dofs.size(); ++k) {
    const auto found = std::ranges::find(second.dofs, first.dofs[k]);
    if (found == second.dofs.end()) continue;
    common.dofs.push_back(first.dofs[k]);
    rows.push_back(static_cast<Eigen::Index>(k));
    others.push_back(found - second.dofs.begin());
  }
  if (rows.empty()) {
    throw InputError("the two sets of modes have no point in common",
                     "modes",
                     "use the same grid numbers and directions in both");
  }
  common.first = rows_of(first, rows);
  common.second = rows_of(second, others);
  common.first_sd.setConstant(common.first.rows(),
                              common.first.cols(),
                              std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < first.modes.size(); ++k) {
    if (first.modes[k].shape_sd.size() != first.modes[k].shape.size()) continue;
    common.first_sd.col(static_cast<Eigen::Index>(k)) =
        first.modes[k].shape_sd(rows);
  }
  common.pairs = modal::pair_modes(common.first,
                                   frequencies(first),
                                   common.second,
                                   frequencies(second),
                                   {},
                                   by_hand);
  return common;
}

/// None where the uncertainty of the first set's shape is not known.
std::optional<modal::MacEstimate> estimate(const Common& common,
                                           const modal::Pair& pair) {
  const Eigen::VectorXd sd = common.first_sd.col(pair.measured);
  if (!sd.allFinite()) return std::nullopt;
  return modal::mac_with_uncertainty(
      common.first.col(pair.measured), sd, common.second.col(pair.model));
}

ordered_json mac_of_pair_json(const Common& common, const modal::Pair& pair) {
  if (const auto found = estimate(common, pair)) {
    return {{"value", found->value},
            {"sd", found->sd},
            {"lo95", found->lo95},
            {"hi95", found->hi95}};
  }
  return {{"value", pair.mac},
          {"sd", nullptr},
          {"lo95", nullptr},
          {"hi95", nullptr}};
}

/// The columns of both that are paired.
std::pair<Eigen::MatrixXcd, Eigen::MatrixXcd> paired(const Common& common) {
  std::vector<Eigen::Index> left;
  std::vector<Eigen::Index> right;
  for (const modal::Pair& pair : common.pairs) {
    left.push_back(pair.measured);
    right.push_back(pair.model);
  }
  return {common.first(Eigen::all, left), common.second(Eigen::all, right)};
}

std::string matrix_text(const modal::ModeSet& first,
                        const modal::ModeSet& second,
                        const Eigen::MatrixXd& mac) {
  std::vector<std::string> heading{"Hz"};
  for (const modal::Mode& mode : second.modes) {
    heading.push_back(fmt::format("{:.5g}", mode.frequency_hz));
  }
  TextTable table(heading);
  for (Eigen::Index i = 0; i < mac.rows(); ++i) {
    std::vector<std::string> row{fmt::format(
        "{:.5g}", first.modes[static_cast<std::size_t>(i)].frequency_hz)};
    for (const double value : mac.row(i)) {
      row.push_back(fmt::format("{:.0f}", 100.0 * value));
    }
    table.add(row);
  }
  return table.text();
}

std::string pairs_text(const modal::ModeSet& first,
                       const modal::ModeSet& second,
                       const Common& common) {
  TextTable table({"first", "second", "Hz", "Hz", "error %", "MAC", "sd"});
  for (const modal::Pair& pair : common.pairs) {
    const double f =
        first.modes[static_cast<std::size_t>(pair.measured)].frequency_hz;
    const double g =
        second.modes[static_cast<std::size_t>(pair.model)].frequency_hz;
    const std::optional<modal::MacEstimate> mac = estimate(common, pair);
    table.add({fmt::format("{}", pair.measured + 1),
               fmt::format("{}", pair.model + 1),
               fmt::format("{:.5g}", f),
               fmt::format("{:.5g}", g),
               fmt::format("{:+.2f}", 100.0 * (g / f - 1.0)),
               fmt::format("{:.4f}", mac ? mac->value : pair.mac),
               mac ? fmt::format("{:.1g}", mac->sd) : std::string("unknown")});
  }
  return common.pairs.empty() ? "  none: no shapes are alike\n" : table.text();
}

}  // namespace

ordered_json mac_json(const modal::ModeSet& first,
                      const modal::ModeSet& second,
                      const std::vector<modal::Pair>& by_hand) {
  const Common common = common_points(first, second, by_hand);
  const Eigen::MatrixXd mac = modal::mac(common.first, common.second);
  ordered_json matrix = ordered_json::array();
  for (Eigen::Index i = 0; i < mac.rows(); ++i) {
    matrix.push_back(std::vector<double>(mac.row(i).begin(), mac.row(i).end()));
  }
  ordered_json pairs = ordered_json::array();
  for (const modal::Pair& pair : common.pairs) {
    const double f =
        first.modes[static_cast<std::size_t>(pair.measured)].frequency_hz;
    const double g =
        second.modes[static_cast<std::size_t>(pair.model)].frequency_hz;
    pairs.push_back({{"first", pair.measured + 1},
                     {"second", pair.model + 1},
                     {"first_hz", f},
                     {"second_hz", g},
                     {"error_percent", 100.0 * (g / f - 1.0)},
                     {"mac", mac_of_pair_json(common, pair)}});
  }
  const auto [left, right] = paired(common);
  const Eigen::VectorXd comac =
      modal::comac(modal::in_scale_of(left, right), right);
  ordered_json points = ordered_json::object();
  for (std::size_t k = 0; k < common.dofs.size(); ++k) {
    points[name(common.dofs[k])] = comac(static_cast<Eigen::Index>(k));
  }
  ordered_json steps = ordered_json::array();
  if (!common.pairs.empty()) {
    for (const modal::LeftOut& step : modal::macco(left, right, kMaccoSteps)) {
      steps.push_back(
          {{"left_out", name(common.dofs[static_cast<std::size_t>(step.dof)])},
           {"mean_mac", step.mean_mac}});
    }
  }
  return {{"points", common.dofs.size()},
          {"mac", std::move(matrix)},
          {"pairs", std::move(pairs)},
          {"comac", std::move(points)},
          {"macco", std::move(steps)}};
}

std::string mac_text(const modal::ModeSet& first,
                     const modal::ModeSet& second,
                     const std::vector<modal::Pair>& by_hand) {
  const Common common = common_points(first, second, by_hand);
  std::string text =
      fmt::format("MAC in % at {} points\n", common.dofs.size()) +
      matrix_text(first, second, modal::mac(common.first, common.second)) +
      "Pairs\n" + pairs_text(first, second, common);
  if (common.pairs.empty()) return text;
  const auto [left, right] = paired(common);
  text += fmt::format(
      "Mean MAC of the pairs {:.4f}; without the sensors that lower it most\n",
      modal::mac(left, right).diagonal().mean());
  const Eigen::VectorXd comac =
      modal::comac(modal::in_scale_of(left, right), right);
  TextTable table({"<left out", "mean MAC", "CoMAC"});
  for (const modal::LeftOut& step : modal::macco(left, right, kMaccoSteps)) {
    table.add({name(common.dofs[static_cast<std::size_t>(step.dof)]),
               fmt::format("{:.4f}", step.mean_mac),
               fmt::format("{:.3f}", comac(step.dof))});
  }
  return text + table.text();
}

std::string mac_command(const CommandOptions& options, const Progress&) {
  const modal::ModeSet first = modal::read_modes_file(options.input);
  std::vector<modal::Pair> by_hand;
  for (const std::string& text : options.by_hand.pairs) {
    if (const auto pair = parse_pair(text)) by_hand.push_back(*pair);
  }
  const modal::ModeSet second =
      options.other ? modal::read_modes_file(*options.other) : first;
  if (options.json) return json_text(mac_json(first, second, by_hand));
  return mac_text(first, second, by_hand);
}

}  // namespace tapfit::tui
