#include "updating/search/screen_mistakes.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/point_scan.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <tuple>

namespace tapfit::updating {
namespace {

// Of the square of the misfit, what FRFs must have in it for a mistake of some
// of them to be looked at: half of what a rung must take away, since the rest
// may readjust.
constexpr double least_share = 0.5 * (1.0 - worth_it * worth_it);

// In all runs, or in some. Sizes of a list are one place, as those of a
// parameter are, which pays for being fitted instead.
double distinct_places(const effects::Effect& effect,
                       const std::vector<Location>& places,
                       bool whole) {
  std::set<std::tuple<std::vector<std::string>,
                      std::vector<int>,
                      std::vector<int>,
                      std::string>>
      known;
  for (const Location& where : places) {
    if (where.runs.empty() != whole) continue;
    const bool sized = !effect.fixed(where).empty();
    known.insert({where.channels,
                  where.nodes,
                  where.runs,
                  sized ? std::string() : where.variant});
  }
  return static_cast<double>(known.size());
}

// Those that are left stand for all places, those in some runs for their
// like: there are many more of them.
// @param times how many each of the places is
void stand_for(const std::vector<Location>& places,
               double times,
               std::vector<Screened>& left) {
  if (left.empty()) return;
  const effects::Effect& effect = *left.front().placed.effect;
  for (const bool whole : {true, false}) {
    const double all = times * distinct_places(effect, places, whole);
    const auto is_one = [&](const Screened& s) {
      return s.placed.where.runs.empty() == whole;
    };
    const auto count = std::ranges::count_if(left, is_one);
    for (Screened& s : left) {
      if (is_one(s)) s.places = all / static_cast<double>(count);
    }
  }
}

void add_plain(const effects::Effect& effect,
               const effects::TestContext& context,
               const PointScan& scan,
               std::vector<Screened>& result) {
  const std::vector<Location> places = effect.places(context);
  std::vector<Screened> each;
  for (const Location& where : places) {
    if (!where.runs.empty() && scan.share(where) < least_share) continue;
    each.push_back({{&effect, where, {}}});
  }
  for_each_parallel(each.size(), [&](std::size_t k) {
    each[k].error = scan.error_without(each[k].placed);
  });
  stand_for(places, 1.0, each);
  std::ranges::move(each, std::back_inserter(result));
}

void add_elsewhere(const effects::Effect& effect,
                   const effects::TestContext& context,
                   PointScan& scan,
                   std::vector<Screened>& result) {
  const std::vector<Location> points = effect.places(context);
  PointScanOptions options;
  options.least_share = least_share;
  std::vector<Screened> each;
  for (const PointElsewhere& there : scan.elsewhere(points, options)) {
    each.push_back({{&effect, there.where, {}}, there.error});
  }
  const structure::Deck& deck = *context.deck;
  const std::size_t grids = deck.grids.size() - deck.measuring.size();
  stand_for(points, static_cast<double>(grids), each);
  std::ranges::move(each, std::back_inserter(result));
}

}  // namespace

bool is_screened_mistake(const effects::Effect& effect,
                         const effects::TestContext& context) {
  if (effect.entry() != effects::Entry::Measurement) return false;
  if (effect.takes_any_grid()) return true;
  const std::vector<Location> places = effect.places(context);
  return !places.empty() && effect.parameters(places.front(), context).empty();
}

std::vector<Screened> screen_mistakes(const Fit& current,
                                      const Target& target,
                                      const ProjectedMisfit& misfit,
                                      const signal::FrfSet& measured) {
  const effects::TestContext& context = current.model->context();
  PointScan scan(current, target, misfit, measured);
  std::vector<Screened> result;
  for (const effects::Effect* effect : effects::catalogue()) {
    if (!is_screened_mistake(*effect, context)) continue;
    if (effect->takes_any_grid()) {
      add_elsewhere(*effect, context, scan, result);
    } else {
      add_plain(*effect, context, scan, result);
    }
  }
  return result;
}

}  // namespace tapfit::updating
