#include "tui/report/point_places.hpp"

#include "acquisition/foundation/dof.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

std::vector<double> numbers_of(const Eigen::Vector3d& x) {
  return {x.begin(), x.end()};
}

std::string laid_over_text(const structure::LaidOver& laid) {
  const std::string by =
      laid.pairs > 0 ? fmt::format("{} pairs", laid.pairs) : "best fit";
  const double turn =
      std::acos(std::clamp(0.5 * (laid.rotation.trace() - 1.0), -1.0, 1.0));
  return fmt::format(
      "  the test's mesh is laid over the model by {}: turned by {:.1f} "
      "degrees, moved by {:.4g}, {:.4g}, {:.4g} m, {:.2g} mm rms are left\n",
      by,
      turn * 180.0 / M_PI,
      laid.translation.x(),
      laid.translation.y(),
      laid.translation.z(),
      1e3 * laid.rms_m);
}

ordered_json laid_over_json(const structure::LaidOver& laid) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index i = 0; i < 3; ++i) {
    rows.push_back(numbers_of(laid.rotation.row(i).transpose()));
  }
  return {{"by", laid.pairs > 0 ? "pairs" : "best fit"},
          {"rotation", std::move(rows)},
          {"translation_m", numbers_of(laid.translation)},
          {"rms_m", laid.rms_m}};
}

// A tenth of a millimetre, without a sign where it is none.
std::string coordinate(double x) {
  const double digits = std::round(1e4 * x);
  return fmt::format("{:.4f}", digits == 0.0 ? 0.0 : 1e-4 * digits);
}

}  // namespace

std::string point_places_text(const structure::Deck& deck) {
  if (deck.measuring.empty()) return {};
  TextTable table({"<point",
                   "x m",
                   "y m",
                   "z m",
                   "<on",
                   "from it mm",
                   "<nearest grid",
                   "mm"});
  for (const structure::MeasuringPoint& point : deck.measuring) {
    const Eigen::Vector3d& at =
        deck.grids[deck.grid_index(point.grid)].position;
    table.add({node_name(point.grid),
               coordinate(at.x()),
               coordinate(at.y()),
               coordinate(at.z()),
               point.on,
               fmt::format("{:.2f}", 1e3 * point.off),
               fmt::format("{}", point.nearest),
               fmt::format("{:.2f}", 1e3 * point.to_grid)});
  }
  return table.text() + (deck.laid_over ? laid_over_text(*deck.laid_over) : "");
}

void add_point_places(const structure::Deck& deck, ordered_json& object) {
  if (deck.measuring.empty()) return;
  ordered_json list = ordered_json::array();
  for (const structure::MeasuringPoint& point : deck.measuring) {
    ordered_json axes = ordered_json::object();
    for (Eigen::Index i = 0; i < 3; ++i) {
      axes[std::string(1, "XYZ"[i])] = numbers_of(point.axes.col(i));
    }
    list.push_back(
        {{"point", node_name(point.grid)},
         {"at", numbers_of(deck.grids[deck.grid_index(point.grid)].position)},
         {"axes", std::move(axes)},
         {"on", point.on},
         {"off_m", point.off},
         {"nearest_grid", point.nearest},
         {"to_grid_m", point.to_grid}});
  }
  object["point_places"] = std::move(list);
  if (deck.laid_over) object["laid_over"] = laid_over_json(*deck.laid_over);
}

}  // namespace tapfit::tui
