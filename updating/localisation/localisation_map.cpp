#include "updating/localisation/localisation_map.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/location_scan.hpp"

#include <algorithm>

namespace tapfit::updating {

std::vector<GridShare> localisation_map(const Fit& current,
                                        const Target& target,
                                        const Progress& progress) {
  const FrfModel& model = *current.model;
  const effects::TestContext& context = model.context();
  std::vector<GridShare> grids;
  ScannedPlaces places;
  for (const Location& where : effects::find("added-mass").places(context)) {
    grids.push_back({where.node, 0.0});
    places.grids.push_back(model.row(where.node, context.component));
  }
  const ProjectedMisfit misfit(current, target);
  const LocationScan scan(current, target, misfit, places, progress);
  // Of one datum a line any place explains all.
  if (target.H.cols() < 2) return grids;
  const double all = std::max(misfit.missing_power(), 1e-300);
  for (std::size_t b = 0; b < grids.size(); ++b) {
    const double left = scan.any_law(b);
    grids[b].explained = std::clamp(1.0 - left * left / all, 0.0, 1.0);
  }
  std::stable_sort(
      grids.begin(), grids.end(), [](const auto& a, const auto& b) {
        return a.explained > b.explained;
      });
  return grids;
}

}  // namespace tapfit::updating
