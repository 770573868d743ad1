#include "updating/search/screened_places.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/preload.hpp"
#include "updating/localisation/location_operators.hpp"
#include "updating/places/element_cells.hpp"

#include <array>
#include <map>
#include <span>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXd;

// The axes along which a point effect is felt: a directed one along its own,
// others along all that were tested, of which one tells most.
std::vector<int> felt_along(const effects::Effect& effect,
                            const Location& where,
                            const effects::TestContext& context) {
  const bool directed = effect.sits() == effects::Sits::AlongAxis;
  if (directed || context.components.empty()) {
    return {effects::component_of(where, context)};
  }
  return context.components;
}

// Takes point effects, each with the others that may sit where it may.
void add_points(std::span<const effects::Effect* const> effects,
                const Fitter& fitter,
                const LocationOperators& source,
                ScreenedPlaces& places) {
  const effects::TestContext& context = fitter.problem().context;
  std::map<std::pair<int, int>, std::size_t> known;  // grid and axis
  for (const effects::Effect* effect : effects) {
    if (!effect->sits_at_grid()) continue;
    for (const Location& where : fitter.places(*effect)) {
      for (const int along : felt_along(*effect, where, context)) {
        MatrixXd row = source.grid(where.node, along);
        // A plane model does not move out of its plane.
        if (along != context.component && row.isZero(0.0)) continue;
        const auto [it, fresh] =
            known.try_emplace({where.node, along}, places.points.size());
        if (fresh) {
          places.points.emplace_back();
          places.scanned.grids.push_back(std::move(row));
        }
        const bool single = effect->parameters(where, context).size() == 1;
        ScreenedPlaces::Kinds& kinds = places.points[it->second];
        (single ? kinds.simple : kinds.detailed).push_back({effect, where, {}});
      }
    }
  }
}

void add_losses(const effects::Effect& effect,
                const Fitter& fitter,
                LocationOperators& source,
                ScreenedPlaces& places) {
  std::map<int, std::size_t> at;  // first element of a cell -> its rows
  for (const ElementCell& cell :
       element_cells(*fitter.problem().context.deck)) {
    at[cell.elements.front()] = places.scanned.parts.size();
    places.scanned.parts.push_back(source.cell(cell));
  }
  for (const Location& where : fitter.places(effect)) {
    std::vector<std::size_t> sum;
    for (const int id : where.elements) {
      const auto cell = at.find(id);
      if (cell != at.end()) sum.push_back(cell->second);
    }
    places.wide.push_back({&effect, where});
    places.scanned.sums.push_back(std::move(sum));
  }
}

void add_preloads(const effects::Effect& effect,
                  const Fitter& fitter,
                  LocationOperators& source,
                  ScreenedPlaces& places) {
  std::map<std::pair<std::vector<int>, bool>, std::size_t> known;
  for (const Location& where : fitter.places(effect)) {
    // What is pulled and pushed there is felt by the same rows.
    const bool across = where.variant.starts_with("across");
    const auto [it, fresh] = known.try_emplace({where.elements, across},
                                               places.scanned.parts.size());
    if (fresh) places.scanned.parts.push_back(source.preload(where));
    if (places.scanned.parts[it->second].rows() == 0) continue;
    places.wide.push_back({&effect, where});
    places.scanned.sums.push_back({it->second});
  }
}

}  // namespace

ScreenedPlaces screened_grids(const effects::Effect& effect,
                              const FrfModel& model,
                              const Fitter& fitter) {
  ScreenedPlaces places;
  const std::array<const effects::Effect*, 1> one = {&effect};
  add_points(one, fitter, LocationOperators(model), places);
  return places;
}

ScreenedPlaces screened_places(const FrfModel& model, const Fitter& fitter) {
  LocationOperators source(model);
  ScreenedPlaces places;
  add_points(effects::catalogue(), fitter, source, places);
  for (const effects::Effect* effect : effects::catalogue()) {
    const auto change = effect->changes_stiffness();
    if (change == ChangeKind::Elements) {
      add_losses(*effect, fitter, source, places);
    }
    if (change == ChangeKind::Preload) {
      add_preloads(*effect, fitter, source, places);
    }
    if (change != ChangeKind::Joint) continue;
    for (const Location& where : fitter.places(*effect)) {
      MatrixXd rows = source.joint(where);
      if (rows.rows() == 0) continue;
      places.wide.push_back({effect, where});
      places.scanned.sums.push_back({places.scanned.parts.size()});
      places.scanned.parts.push_back(std::move(rows));
    }
  }
  return places;
}

}  // namespace tapfit::updating
