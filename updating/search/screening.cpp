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

// A scan over all sizes, then closer around the best, one parameter after the
// other.
template <typename Best>
Screened scanned(const std::vector<effects::ParameterSpec>& specs,
                 const Best& best) {
  Screened found = best(size_grid(specs));
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

class Screening {
 public:
  /// @param current its model may be asked about any grid
  Screening(const Fit& current, const Fitter& fitter, const Progress& progress)
      : context_(fitter.problem().context),
        fitter_(&fitter),
        current_(&current),
        measured_(&fitter.problem().measured),
        // The widest line: the most forgiving about shifts.
        target_(&fitter.problem().targets.front()),
        places_(screened_places(*current.model, fitter)),
        scan_(current, *target_),
        place_scan_(current, *target_, scan_, places_.scanned, progress),
        now_(
            current.model->respond(current.result.state, target_->s, false).H) {
  }

  [[nodiscard]] std::vector<Screened> points() const {
    std::vector<std::size_t> all(places_.points.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return at_points(all, &ScreenedPlaces::Kinds::simple);
  }

  // Effects of several parameters, at the most promising grids.
  [[nodiscard]] std::vector<Screened> detailed() const {
    std::vector<double> any_law(places_.points.size());
    for (std::size_t b = 0; b < any_law.size(); ++b) {
      any_law[b] = place_scan_.any_law(b);
    }
    std::set<std::size_t> best = least_of(any_law);
    best.merge(least_of(rough_errors()));
    return at_points({best.begin(), best.end()},
                     &ScreenedPlaces::Kinds::detailed);
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
      result[k] =
          scanned(candidate.effect->parameters(candidate.where, context_),
                  [&](const auto& tried) {
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

  // Of every point what the best of few sizes of its effects of several
  // parameters leaves.
  [[nodiscard]] std::vector<double> rough_errors() const {
    std::map<const effects::Effect*, MatrixXcd> laws;
    for (const ScreenedPlaces::Kinds& kinds : places_.points) {
      for (const EffectInstance& e : kinds.detailed) {
        if (laws.contains(e.effect)) continue;
        const auto specs = e.effect->parameters(e.where, context_);
        laws[e.effect] = laws_of(e, size_grid(specs, {4, 24, 1}));
      }
    }
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
  [[nodiscard]] std::vector<Screened> at_points(
      const std::vector<std::size_t>& points,
      std::vector<EffectInstance> ScreenedPlaces::Kinds::*kinds) const {
    std::vector<std::vector<Screened>> each(points.size());
    for_each_parallel(points.size(), [&](std::size_t k) {
      const std::size_t b = points[k];
      const double any_law = place_scan_.any_law(b);
      for (const EffectInstance& effect : places_.points[b].*kinds) {
        each[k].push_back(scanned(
            effect.effect->parameters(effect.where, context_),
            [&](const auto& tried) { return best_at_grid(b, effect, tried); }));
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

}  // namespace

std::vector<Screened> screen(const Fit& current,
                             const Fitter& fitter,
                             const Progress& progress) {
  Fit anywhere = current;
  anywhere.model = fitter.model_for(current.effects, BaseUse::Scan);
  const Screening screening(anywhere, fitter, progress);
  progress("screening", 0.5);
  std::vector<Screened> result = screening.points();
  for (const auto& more : {screening.detailed(),
                           screening.wide(),
                           screening.few(),
                           screening.mistakes(),
                           screening.clamps()}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.error < b.error;
  });
  return result;
}

}  // namespace tapfit::updating
