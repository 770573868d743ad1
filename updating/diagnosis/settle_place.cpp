#include "updating/diagnosis/settle_place.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/diagnosis/place_parabola.hpp"
#include "updating/places/between_grids.hpp"
#include "updating/places/near_places.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

TriedPlace tried_at(const Hypothesis& h,
                    const structure::Deck& deck,
                    const Judgement& judgement) {
  const std::vector<double>& p = h.own().p;
  const auto n = static_cast<Index>(p.size());
  return {
      position_of(h.own().where, deck),
      estimate_form(h.fit.form, judgement.data, judgement.noise).log_likelihood,
      Eigen::Map<const VectorXd>(p.data(), n).array().log()};
}

// Fits the effect at several places, in one base.
std::vector<Hypothesis> fit_at(const std::vector<Location>& places,
                               const Hypothesis& like,
                               const Fit& current,
                               const Fitter& fitter,
                               const Progress& progress) {
  std::vector<EffectInstance> all = current.effects;
  for (const Location& where : places) {
    all.push_back(like.own());
    all.back().where = where;
  }
  const auto model = fitter.model_for(all);
  std::vector<Hypothesis> result(places.size());
  const Progress quiet{{}, progress.stop};
  for_each_parallel(places.size(), [&](std::size_t k) {
    std::vector<EffectInstance> effects = current.effects;
    effects.push_back(like.own());
    effects.back().where = places[k];
    result[k].fit = fitter.fit_beside(like.fit, effects, model, quiet);
    result[k].places = like.places;
  });
  return result;
}

// Places where the parabola has its top and where it is about one below.
struct Ring {
  std::vector<Location> places;
  double reach = 0.0;  // the longest way from its middle, in grid spacings
};

Ring ring_around(const PlaceParabola& q,
                 const Location& top,
                 const structure::Deck& deck) {
  constexpr double furthest = 0.6;  // from what was tried, in grid spacings
  constexpr double least = 1.0 / 64.0;
  constexpr double most = 0.25;
  const VectorXd middle =
      q.top * std::min(1.0, furthest / std::max(q.top.norm(), 1e-12));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(q.covariance);
  const VectorXd way =
      (1.4 * solver.eigenvalues().cwiseSqrt()).cwiseMax(least).cwiseMin(most);
  const MatrixXd along = solver.eigenvectors() * way.asDiagonal();
  std::vector<VectorXd> off = {VectorXd::Zero(q.top.size())};
  for (Index k = 0; k < along.cols(); ++k) {
    off.emplace_back(along.col(k));
    off.emplace_back(-along.col(k));
  }
  if (along.cols() == 2) {
    off.emplace_back(M_SQRT1_2 * along.rowwise().sum());
    off.emplace_back(-off.back());
  }
  Ring ring;
  ring.reach = way.maxCoeff();
  const Vector3d from = position_of(top, deck);
  for (const VectorXd& z : off) {
    std::vector<Location> there =
        moved_to(top, from + q.axes * (middle + z), deck);
    std::move(there.begin(), there.end(), std::back_inserter(ring.places));
  }
  return ring;
}

// How far the places that were looked at are from the next, in sides of an
// element: more than one on a fine mesh.
double places_apart(const Hypothesis& best, const Fitter& fitter) {
  const structure::Deck& deck = *fitter.problem().context.deck;
  const Location& own = best.own().where;
  const std::vector<Location> near =
      places_near(own, fitter.places(*best.own().effect), deck, 1);
  return sides_apart(own, near.back().node, deck);
}

}  // namespace

Hypothesis settle_place(const Hypothesis& best,
                        const Fit& current,
                        const Fitter& fitter,
                        const Judgement& judgement,
                        const Progress& progress) {
  constexpr std::array<double, 2> steps = {0.5, 0.25};
  // Of log likelihood: one for each coordinate, without which it is said to sit
  // where it was.
  constexpr double worth_moving = 2.0;
  // Each looks at least twice as closely as the last.
  constexpr int most_turns = 3;
  const structure::Deck& deck = *fitter.problem().context.deck;
  Hypothesis settled = best;
  TriedPlace top = tried_at(best, deck, judgement);
  std::vector<TriedPlace> tried = {top};
  const auto take = [&](const std::vector<Location>& places) {
    for (Hypothesis& h : fit_at(places, settled, current, fitter, progress)) {
      tried.push_back(tried_at(h, deck, judgement));
      if (tried.back().log_likelihood <= top.log_likelihood) continue;
      top = tried.back();
      settled = std::move(h);
    }
  };
  const double spacing = places_apart(best, fitter);
  for (const double step : steps) {
    const std::vector<Location> places =
        places_around(settled.own().where, step * spacing, deck);
    if (!places.empty()) take(places);
  }
  double reach = steps.back();
  for (int turn = 0; turn < most_turns; ++turn) {
    const std::optional<PlaceParabola> q = parabola_through(tried, top);
    if (!q) break;
    const Ring ring = ring_around(*q, settled.own().where, deck);
    const bool told = turn > 0 && ring.reach > 0.5 * reach;
    if (told) break;
    reach = ring.reach;
    take(ring.places);
  }
  if (const auto q = parabola_through(tried, top)) {
    settled.place_sd = size_deviations(*q);
  }
  if (top.log_likelihood > tried.front().log_likelihood + worth_moving) {
    return settled;
  }
  Hypothesis stays = best;
  stays.place_sd = std::move(settled.place_sd);
  return stays;
}

}  // namespace tapfit::updating
