#include "updating/search/screening.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/preload.hpp"
#include "updating/fit/size_grid.hpp"
#include "updating/localisation/location_scan.hpp"
#include "updating/localisation/projected_misfit.hpp"
#include "updating/search/screen_clamps.hpp"
#include "updating/search/screen_mistakes.hpp"
#include "updating/search/screened_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Grids at which effects of several parameters are scanned: as many where a
// point effect of any law would explain most, and where they do best roughly.
// What readjusts is in the second alone, and the law is theirs.
constexpr std::size_t grids_in_detail = 12;

// A scan over sizes, then closer around the best, one parameter after the
// other.
template <typename Best>
Screened scanned(const std::vector<effects::ParameterSpec>& specs,
                 const std::vector<std::vector<double>>& sizes,
                 const Best& best) {
  Screened found = best(sizes);
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const double step = std::log(specs[k].upper / specs[k].lower) / 13.0;
    std::vector<std::vector<double>> tried;
    for (const double part :
         {-0.9, -0.6, -0.35, -0.15, 0.0, 0.15, 0.35, 0.6, 0.9}) {
      tried.push_back(found.placed.p);
      tried.back()[k] *= std::exp(part * step);
    }
    found = best(tried);
  }
  return found;
}

// The same of a resonance that is tuned: smaller where the mode moves more.
std::vector<std::vector<double>> sizes_like(const EffectInstance& own) {
  std::vector<std::vector<double>> tried;
  for (double share = 1.0 / 16.0; share <= 16.0; share *= M_SQRT2) {
    tried.push_back(own.p);
    tried.back().front() *= share;
  }
  return tried;
}

class Screening {
 public:
  /// @param current its model may be asked about any grid
  Screening(const Fit& current,
            const Fitter& fitter,
            const Target& target,
            ScreenedPlaces places,
            const Progress& progress)
      : context_(fitter.problem().context),
        fitter_(&fitter),
        current_(&current),
        measured_(&fitter.problem().measured),
        target_(&target),
        places_(std::move(places)),
        scan_(current, *target_),
        place_scan_(current, *target_, scan_, places_.scanned, progress),
        now_(
            current.model->respond(current.result.state, target_->s, false).H) {
  }

  [[nodiscard]] std::vector<Screened> points() const {
    std::vector<std::size_t> all(places_.points.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return at_points({all.begin(), all.end()}, &ScreenedPlaces::Kinds::simple);
  }

  // The same effect at the most promising points, around the sizes that it has
  // at one.
  [[nodiscard]] std::vector<Screened> like(const EffectInstance& own) const {
    const auto sizes = sizes_like(own);
    const std::set<std::size_t> best =
        least_of(errors_with({{own.effect, laws_of(own, sizes)}}));
    return at_points(best, &ScreenedPlaces::Kinds::detailed, &sizes);
  }

  // Effects of several parameters, at the most promising grids.
  [[nodiscard]] std::vector<Screened> detailed() const {
    std::vector<double> any_law(places_.points.size());
    for (std::size_t b = 0; b < any_law.size(); ++b) {
      any_law[b] = place_scan_.any_law(b);
    }
    std::set<std::size_t> best = least_of(any_law);
    best.merge(least_of(errors_with(rough_laws())));
    return at_points(best, &ScreenedPlaces::Kinds::detailed);
  }

  [[nodiscard]] std::vector<Screened> wide() const {
    std::vector<Screened> result(places_.wide.size());
    for (std::size_t k = 0; k < result.size(); ++k) {
      const ScreenedPlaces::Wide& place = places_.wide[k];
      if (place.effect->changes_stiffness() == ChangeKind::Preload) {
        result[k] = preloaded(k);
        continue;
      }
      const ProjectedMisfit::Scaled best = place_scan_.scaled(k);
      const double factor = std::max(best.factor, 1e-12);
      // A joint's stiffness is the inverse of its compliance; elements in a
      // row add compliance, 1 / factor - 1.
      const bool loss =
          place.effect->changes_stiffness() == ChangeKind::Elements;
      const double p = loss ? 1.0 / (1.0 + factor) : 1.0 / factor;
      result[k] = {EffectInstance{place.effect, place.where, {p}}, best.error};
    }
    return result;
  }

  [[nodiscard]] std::vector<Screened> mistakes() const {
    return screen_mistakes(*current_, *target_, scan_, *measured_);
  }

  [[nodiscard]] std::vector<Screened> clamps() const {
    return promising_clamps(
        screen_clamps(*current_, *fitter_, *target_, scan_, now_), scan_);
  }

  // Effects at few places, which a model can respond to: those of sensors and
  // channels. Every size is worked out, none estimated, in the base that their
  // fits would have: of 35 to 80 coordinates where that for all grids has 150.
  [[nodiscard]] std::vector<Screened> few() const {
    std::vector<EffectInstance> candidates;
    for (const effects::Effect* effect : effects::catalogue()) {
      if (effect->changes_stiffness() ||
          effect->entry() == effects::Entry::Damping ||
          effect->corrects_deck() || effect->sits_at_grid() ||
          is_screened_mistake(*effect, context_)) {
        continue;
      }
      for (const Location& place : fitter_->places(*effect)) {
        candidates.push_back(placed(*effect, place, context_));
      }
    }
    std::vector<EffectInstance> together = current_->effects;
    together.insert(together.end(), candidates.begin(), candidates.end());
    const auto model = fitter_->model_for(together);
    const MatrixXcd now =
        model->respond(current_->result.state, target_->s, false).H;
    std::vector<Screened> result(candidates.size());
    for_each_parallel(candidates.size(), [&](std::size_t k) {
      const EffectInstance& candidate = candidates[k];
      const auto specs =
          candidate.effect->parameters(candidate.where, context_);
      result[k] = scanned(specs, size_grid(specs), [&](const auto& tried) {
        return best_response(candidate, tried, *model, now);
      });
    });
    return result;
  }

 private:
  // The most promising of all points.
  static std::set<std::size_t> least_of(const std::vector<double>& errors) {
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(
        order, {}, [&errors](std::size_t b) { return errors[b]; });
    order.resize(std::min(grids_in_detail, order.size()));
    return {order.begin(), order.end()};
  }

  // Each kind's own, a column for each of its sizes.
  using Laws = std::map<const effects::Effect*, MatrixXcd>;

  // Of few sizes of the effects of several parameters.
  [[nodiscard]] Laws rough_laws() const {
    Laws laws;
    for (const ScreenedPlaces::Kinds& kinds : places_.points) {
      for (const EffectInstance& e : kinds.detailed) {
        if (laws.contains(e.effect)) continue;
        const auto specs = e.effect->parameters(e.where, context_);
        laws[e.effect] = laws_of(e, size_grid(specs, {4, 24, 1}));
      }
    }
    return laws;
  }

  // What the best of the laws leaves at every point.
  [[nodiscard]] std::vector<double> errors_with(const Laws& laws) const {
    std::vector<double> errors(places_.points.size(), 1e300);
    for_each_parallel(errors.size(), [&](std::size_t b) {
      for (const EffectInstance& e : places_.points[b].detailed) {
        const VectorXd left = place_scan_.errors(b, laws.at(e.effect));
        errors[b] = std::min(errors[b], left.minCoeff());
      }
    });
    return errors;
  }

  // Its law on all lines, a column for each of several sizes.
  [[nodiscard]] MatrixXcd laws_of(
      const EffectInstance& effect,
      const std::vector<std::vector<double>>& tried) const {
    MatrixXcd z(target_->s.size(), static_cast<Index>(tried.size()));
    for (std::size_t k = 0; k < tried.size(); ++k) {
      for (Index l = 0; l < z.rows(); ++l) {
        z(l, static_cast<Index>(k)) =
            effect.effect->law(target_->s(l), tried[k], 0);
      }
    }
    return z;
  }

  // The best force in a member; of a wire one that is as long as it.
  [[nodiscard]] Screened preloaded(std::size_t k) const {
    const ScreenedPlaces::Wide& place = places_.wide[k];
    const double sign = effects::is_compression(place.where) ? 1.0 : -1.0;
    const ProjectedMisfit::Scaled best = place_scan_.scaled(k, sign);
    EffectInstance found = placed(*place.effect, place.where, context_);
    found.p[0] = std::max(best.factor, 1e-12);
    const auto member =
        effects::member_at(*context_.deck, place.where.elements, place.where);
    if (found.p.size() > 1) found.p[1] = found.p[0] / member->length;
    return {std::move(found), best.error};
  }

  // What may sit at some of the points.
  // @param sizes to begin with, if not all that there may be
  [[nodiscard]] std::vector<Screened> at_points(
      const std::set<std::size_t>& at,
      std::vector<EffectInstance> ScreenedPlaces::Kinds::*kinds,
      const std::vector<std::vector<double>>* sizes = nullptr) const {
    const std::vector<std::size_t> points(at.begin(), at.end());
    std::vector<std::vector<Screened>> each(points.size());
    for_each_parallel(points.size(), [&](std::size_t k) {
      const std::size_t b = points[k];
      const double any_law = place_scan_.any_law(b);
      for (const EffectInstance& effect : places_.points[b].*kinds) {
        const auto specs = effect.effect->parameters(effect.where, context_);
        each[k].push_back(scanned(
            specs, sizes ? *sizes : size_grid(specs), [&](const auto& tried) {
              return best_at_grid(b, effect, tried);
            }));
        each[k].back().any_law = any_law;
      }
    });
    std::vector<Screened> result;
    for (const auto& found : each) {
      result.insert(result.end(), found.begin(), found.end());
    }
    return result;
  }

  // The best of several sizes of an effect at a grid.
  [[nodiscard]] Screened best_at_grid(
      std::size_t b,
      const EffectInstance& effect,
      const std::vector<std::vector<double>>& tried) const {
    return best_of(
        effect, tried, place_scan_.errors(b, laws_of(effect, tried)));
  }

  // The same for an effect that a model can respond to.
  // @param now its FRFs without
  [[nodiscard]] Screened best_response(
      const EffectInstance& candidate,
      const std::vector<std::vector<double>>& tried,
      const FrfModel& model,
      const MatrixXcd& now) const {
    ModelState state = current_->result.state;
    state.effects.push_back(candidate);
    MatrixXd changes(2 * target_->H.size(), static_cast<Index>(tried.size()));
    const auto H = model.respond_at_sizes(state, tried, target_->s);
    for (std::size_t k = 0; k < tried.size(); ++k) {
      changes.col(static_cast<Index>(k)) = scan_.change(H[k] - now);
    }
    return best_of(candidate, tried, scan_.errors(changes));
  }

  [[nodiscard]] Screened best_of(EffectInstance candidate,
                                 const std::vector<std::vector<double>>& tried,
                                 const VectorXd& errors) const {
    Index at = 0;
    const double least = errors.minCoeff(&at);
    candidate.p = tried[static_cast<std::size_t>(at)];
    return {std::move(candidate), least};
  }

  const effects::TestContext& context_;
  const Fitter* fitter_;
  const Fit* current_;
  const signal::FrfSet* measured_;
  const Target* target_;
  ScreenedPlaces places_;
  ProjectedMisfit scan_;
  LocationScan place_scan_;
  MatrixXcd now_;  // the model's FRFs as it is
};

void sort_by_error(std::vector<Screened>& found) {
  std::ranges::sort(found, {}, &Screened::error);
}

}  // namespace

std::vector<Screened> screen(const Fit& current,
                             const Fitter& fitter,
                             const Progress& progress) {
  Fit anywhere = current;
  anywhere.model = fitter.model_for(current.effects, BaseUse::Scan);
  // The widest line: the most forgiving about shifts.
  const Target& widest = fitter.problem().targets.front();
  const Screening screening(anywhere,
                            fitter,
                            widest,
                            screened_places(*anywhere.model, fitter),
                            progress);
  progress("screening", 0.5);
  std::vector<Screened> result = screening.points();
  for (const auto& more : {screening.detailed(),
                           screening.wide(),
                           screening.few(),
                           screening.mistakes(),
                           screening.clamps()}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  sort_by_error(result);
  return result;
}

std::vector<Screened> screen_elsewhere(const Fit& current,
                                       const Fit& best,
                                       const Fitter& fitter,
                                       const Progress& progress) {
  const EffectInstance& own = best.result.state.effects.back();
  Fit rest = current;
  rest.result.state = best.result.state;
  rest.result.state.effects.pop_back();
  rest.model = fitter.model_for(current.effects, BaseUse::Scan);
  const Screening screening(rest,
                            fitter,
                            fitter.target(),
                            screened_grids(*own.effect, *rest.model, fitter),
                            progress);
  std::vector<Screened> result = screening.like(own);
  sort_by_error(result);
  return result;
}

}  // namespace tapfit::updating
