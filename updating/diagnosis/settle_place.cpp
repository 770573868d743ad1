#include "updating/diagnosis/settle_place.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/places/between_grids.hpp"
#include "updating/places/near_places.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

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

// What was fitted at one place.
struct Tried {
  Location where;
  double log_likelihood = 0.0;
  VectorXd log_p;
};

Tried tried_at(const Hypothesis& h, const Judgement& judgement) {
  const std::vector<double>& p = h.own().p;
  const auto n = static_cast<Index>(p.size());
  return {
      h.own().where,
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

// Directions, in space, that the places tried lie along; columns of the length
// of a grid spacing.
MatrixXd directions(const std::vector<Tried>& tried,
                    const Vector3d& from,
                    const structure::Deck& deck) {
  constexpr double flat = 0.2;  // of the largest extent
  MatrixXd off(3, static_cast<Index>(tried.size()));
  for (std::size_t k = 0; k < tried.size(); ++k) {
    off.col(static_cast<Index>(k)) = position_of(tried[k].where, deck) - from;
  }
  const double spacing = 2.0 * off.colwise().norm().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(off * off.transpose()));
  const VectorXd& squares = solver.eigenvalues();
  const double least = flat * flat * std::max(squares.maxCoeff(), 0.0);
  const Index count = std::min<Index>(2, (squares.array() > least).count());
  return spacing * solver.eigenvectors().rightCols(count);
}

// Of log likelihood: as far below the top it is like a parabola.
constexpr double parabolic = 4.0;

// The likelihood around a place, and how the parameters go with it.
struct Quadratic {
  MatrixXd axes;        // 3 x d, see directions()
  VectorXd top;         // d, where the likelihood is largest
  MatrixXd covariance;  // d x d, of the place
  MatrixXd slope;       // parameters x d, d ln p / d z
};

// 1, z, squares, and the product where there are places enough to tell.
VectorXd terms(const VectorXd& z, bool product) {
  const Index d = z.size();
  VectorXd row(1 + 2 * d + (product ? 1 : 0));
  row.head(1 + 2 * d) << 1.0, z, 0.5 * z.cwiseAbs2();
  if (product) row(1 + 2 * d) = z(0) * z(1);
  return row;
}

std::optional<Quadratic> quadratic(const std::vector<Tried>& tried,
                                   const Tried& best,
                                   const structure::Deck& deck) {
  const Vector3d from = position_of(best.where, deck);
  Quadratic q;
  q.axes = directions(tried, from, deck);
  const Index d = q.axes.cols();
  const auto n = static_cast<Index>(tried.size());
  const bool product = d == 2 && n >= 6;
  if (d == 0 || n < 1 + 2 * d) return std::nullopt;
  MatrixXd A(n, 1 + 2 * d + (product ? 1 : 0));
  MatrixXd values(n, 1 + best.log_p.size());
  VectorXd weight(n);
  double flattest = -1e300;  // curvature towards any of them
  for (Index k = 0; k < n; ++k) {
    const Tried& t = tried[static_cast<std::size_t>(k)];
    const Vector3d off = position_of(t.where, deck) - from;
    const VectorXd z = (q.axes.transpose() * off).array() /
                       q.axes.colwise().squaredNorm().transpose().array();
    A.row(k) = terms(z, product).transpose();
    values(k, 0) = t.log_likelihood - best.log_likelihood;
    values.row(k).tail(best.log_p.size()) = (t.log_p - best.log_p).transpose();
    // Far down the likelihood is no parabola.
    weight(k) = std::exp(0.5 * values(k, 0) / parabolic);
    if (z.norm() > 0.0) {
      flattest = std::max(flattest, 2.0 * values(k, 0) / z.squaredNorm());
    }
  }
  const MatrixXd fitted = (weight.asDiagonal() * A)
                              .colPivHouseholderQr()
                              .solve(MatrixXd(weight.asDiagonal() * values));
  MatrixXd H = fitted.col(0).segment(1 + d, d).asDiagonal();
  if (product) H(0, 1) = H(1, 0) = fitted(1 + 2 * d, 0);
  // A ridge where the parabola misses the top, and what tells next to nothing
  // of the place: a spacing's deviation.
  constexpr double least_curvature = -1.0;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(H);
  const VectorXd curvature =
      solver.eigenvalues().cwiseMin(std::min(flattest, least_curvature));
  const MatrixXd& turn = solver.eigenvectors();
  q.covariance =
      turn * (-curvature.cwiseInverse()).asDiagonal() * turn.transpose();
  q.top = q.covariance * fitted.col(0).segment(1, d);
  q.slope = fitted.block(1, 1, d, best.log_p.size()).transpose();
  return q;
}

// Of the parameters' logarithms.
std::vector<double> deviations(const Quadratic& q) {
  std::vector<double> sd;
  for (Index k = 0; k < q.slope.rows(); ++k) {
    const VectorXd slope = q.slope.row(k).transpose();
    sd.push_back(std::sqrt(slope.dot(q.covariance * slope)));
  }
  return sd;
}

// Places where the quadratic has its top and where it is about one below.
struct Ring {
  std::vector<Location> places;
  double reach = 0.0;  // the longest way from its middle, in grid spacings
};

Ring ring_around(const Quadratic& q,
                 const Tried& top,
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
  const Vector3d from = position_of(top.where, deck);
  for (const VectorXd& z : off) {
    std::vector<Location> there =
        moved_to(top.where, from + q.axes * (middle + z), deck);
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
  Tried top = tried_at(best, judgement);
  std::vector<Tried> tried = {top};
  const auto take = [&](const std::vector<Location>& places) {
    for (Hypothesis& h : fit_at(places, settled, current, fitter, progress)) {
      tried.push_back(tried_at(h, judgement));
      if (tried.back().log_likelihood <= top.log_likelihood) continue;
      top = tried.back();
      settled = std::move(h);
    }
  };
  const double spacing = places_apart(best, fitter);
  for (const double step : steps) {
    const std::vector<Location> places =
        places_around(top.where, step * spacing, deck);
    if (!places.empty()) take(places);
  }
  double reach = steps.back();
  for (int turn = 0; turn < most_turns; ++turn) {
    const std::optional<Quadratic> q = quadratic(tried, top, deck);
    if (!q) break;
    const Ring ring = ring_around(*q, top, deck);
    const bool told = turn > 0 && ring.reach > 0.5 * reach;
    if (told) break;
    reach = ring.reach;
    take(ring.places);
  }
  if (const auto q = quadratic(tried, top, deck)) {
    settled.place_sd = deviations(*q);
  }
  if (top.log_likelihood > tried.front().log_likelihood + worth_moving) {
    return settled;
  }
  Hypothesis stays = best;
  stays.place_sd = std::move(settled.place_sd);
  return stays;
}

}  // namespace tapfit::updating
