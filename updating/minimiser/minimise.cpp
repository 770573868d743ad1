#include "updating/minimiser/minimise.hpp"

#include "updating/minimiser/bounded_step.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A logarithm that moves by more has left the linear range.
constexpr double longest = 1.0;
// Of the decrease that was promised: less makes the box smaller, more larger.
constexpr double poor = 0.25;
constexpr double good = 0.75;
// What a step that failed leaves of the box, and one that kept its promise
// makes of it.
constexpr double shrink = 0.3;
constexpr double grow = 3.0;
// Of a parameter's own curvature: directions with less are not told by the
// data, and a step along them is no larger than this allows.
constexpr double flattest = 1e-8;

// Curvature that is positive along every direction: a valley where the
// quadratic has a ridge (saddle-free), in units of the parameters' own
// curvature.
MatrixXd made_positive(const MatrixXd& A, const VectorXd& own) {
  const VectorXd unit = own.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(unit.asDiagonal() * A * unit.asDiagonal()));
  const MatrixXd U = own.cwiseSqrt().asDiagonal() * solver.eigenvectors();
  return U * solver.eigenvalues().cwiseAbs().cwiseMax(flattest).asDiagonal() *
         U.transpose();
}

// Half the gradient and half the curvature of f at a point.
struct Quadratic {
  VectorXd g;
  MatrixXd plain;   // w J'J + P
  MatrixXd second;  // w S
  VectorXd own;     // of each parameter alone, plain and positive

  [[nodiscard]] double change(const VectorXd& d, bool with_second) const {
    const double curved = with_second ? d.dot(second * d) : 0.0;
    return 2.0 * g.dot(d) + d.dot(plain * d) + curved;
  }
};

class Search {
 public:
  Search(const Evaluate& evaluate,
         const Prior& prior,
         const MinimiseOptions& options)
      : evaluate_(&evaluate), prior_(&prior), options_(options) {}

  [[nodiscard]] std::optional<Iterate> first(const VectorXd& theta,
                                             const CountData& data) {
    std::optional<Residuals> at = (*evaluate_)(theta);
    if (!at) return std::nullopt;
    data_ = data(at->r);
    return judged(theta, std::move(*at));
  }

  [[nodiscard]] std::optional<Iterate> look(const VectorXd& theta) const {
    std::optional<Residuals> at = (*evaluate_)(theta);
    if (!at) return std::nullopt;
    return judged(theta, std::move(*at));
  }

  /// From the start as far down as it goes.
  [[nodiscard]] Minimum go_down(Iterate start, const OnStep& on_step);

 private:
  enum class Ended { No, Converged, Stuck };

  [[nodiscard]] Iterate judged(const VectorXd& theta, Residuals at) const {
    Iterate point{theta, std::move(at), 0.0, 0.0, 0.0};
    const double misfit = std::max(point.at.r.squaredNorm(), 1e-30);
    point.prior_cost = prior_residuals(*prior_, theta).r.squaredNorm();
    point.objective = data_ * std::log(misfit) + point.prior_cost;
    return point;
  }
  [[nodiscard]] Quadratic quadratic(const Iterate& at) const;
  [[nodiscard]] VectorXd step(const Iterate& at,
                              const Quadratic& q,
                              bool with_second) const;
  // A step that lowers f, if there is one.
  [[nodiscard]] Ended advance(Iterate& at);
  void learn(const Iterate& from, const Iterate& to);

  const Evaluate* evaluate_;
  const Prior* prior_;
  double data_ = 1.0;
  MinimiseOptions options_;
  MatrixXd S_;
  bool with_second_ = false;
  // Of the box, in standard deviations of each parameter by itself.
  double radius_ = std::numeric_limits<double>::infinity();
};

Quadratic Search::quadratic(const Iterate& at) const {
  const double w = data_ / std::max(at.at.r.squaredNorm(), 1e-30);
  Quadratic q;
  const Residuals known = prior_residuals(*prior_, at.theta);
  q.g = w * at.at.J.transpose() * at.at.r + known.J.transpose() * known.r;
  const Index n = at.theta.size();
  q.plain = MatrixXd::Zero(n, n);
  q.plain.selfadjointView<Eigen::Lower>().rankUpdate(at.at.J.transpose(), w);
  q.plain = MatrixXd(q.plain.selfadjointView<Eigen::Lower>());
  q.plain += known.J.transpose() * known.J;
  q.own = q.plain.diagonal().cwiseMax(1e-9);
  q.second = w * S_;
  return q;
}

VectorXd Search::step(const Iterate& at,
                      const Quadratic& q,
                      bool with_second) const {
  const VectorXd reach =
      (radius_ * q.own.cwiseSqrt().cwiseInverse()).cwiseMin(longest);
  MatrixXd A = q.plain;
  if (with_second) A += q.second;
  return bounded_step(made_positive(A, q.own),
                      q.g,
                      (prior_->lower - at.theta).cwiseMax(-reach),
                      (prior_->upper - at.theta).cwiseMin(reach));
}

// S from how the derivatives changed: S s = (J+ - J)' r+, and otherwise as
// near to what it was as it can be.
void Search::learn(const Iterate& from, const Iterate& to) {
  const VectorXd s = to.theta - from.theta;
  const VectorXd y_own = (to.at.J - from.at.J).transpose() * to.at.r;
  const VectorXd y =
      to.at.J.transpose() * to.at.r - from.at.J.transpose() * from.at.r;
  const double along = y.dot(s);
  if (std::abs(along) <= 1e-12 * y.norm() * s.norm()) return;
  const double known = s.dot(S_ * s);
  if (known != 0.0) S_ *= std::min(1.0, std::abs(s.dot(y_own) / known));
  const VectorXd lacks = y_own - S_ * s;
  S_ += (lacks * y.transpose() + y * lacks.transpose()) / along -
        (lacks.dot(s) / (along * along)) * (y * y.transpose());
}

Search::Ended Search::advance(Iterate& at) {
  const Quadratic q = quadratic(at);
  bool both = false;  // kinds of curvature were tried in this box
  while (true) {
    const VectorXd d = step(at, q, with_second_);
    const double moved = d.cwiseAbs().maxCoeff();
    const double promised = -q.change(d, with_second_);
    const double deviations =
        d.cwiseProduct(q.own.cwiseSqrt()).cwiseAbs().maxCoeff();
    const bool whole = deviations < 0.99 * radius_;
    if (moved <= options_.tolerance ||
        (whole && promised <= options_.objective_tolerance)) {
      return Ended::Converged;
    }
    const VectorXd next =
        (at.theta + d).cwiseMax(prior_->lower).cwiseMin(prior_->upper);
    std::optional<Iterate> trial = look(next);
    const double gained = trial ? at.objective - trial->objective : -1e300;
    const bool second_told = std::abs(gained + q.change(d, true)) <
                             std::abs(gained + q.change(d, false));
    const bool other = second_told != with_second_;
    with_second_ = second_told;
    if (gained > 0.0) {
      if (gained < poor * promised) radius_ = 0.5 * deviations;
      if (gained > good * promised && !whole) radius_ *= grow;
      trial->moved = moved;
      learn(at, *trial);
      at = std::move(*trial);
      return Ended::No;
    }
    if (promised <= options_.objective_tolerance) return Ended::Converged;
    // Once more as far where the other curvature foretold this one better.
    const bool again = other && trial && !both;
    both = again;
    radius_ = (again ? 1.0 : shrink) * deviations;
    if (radius_ < options_.tolerance) return Ended::Stuck;
  }
}

Minimum Search::go_down(Iterate start, const OnStep& on_step) {
  Minimum found{std::move(start), data_, false, {}};
  const Index n = found.point.theta.size();
  S_ = MatrixXd::Zero(n, n);
  if (n == 0) {
    found.message = "nothing to identify";
    return found;
  }
  found.message = fmt::format("not converged in {} steps", options_.most_steps);
  if (on_step && !on_step(found.point)) {
    found.message = "stopped by hand";
    return found;
  }
  for (int k = 0; k < options_.most_steps; ++k) {
    const Ended ended = advance(found.point);
    if (ended == Ended::Converged) {
      found.converged = true;
      found.message = "converged";
      break;
    }
    if (ended == Ended::Stuck) {
      found.message = "no step, however short, lowers the error any more";
      break;
    }
    if (on_step && !on_step(found.point)) {
      found.message = "stopped by hand";
      break;
    }
  }
  return found;
}

}  // namespace

Residuals prior_residuals(const Prior& prior, const VectorXd& theta) {
  // Zero where nothing is known.
  const VectorXd per_sd = prior.sd.cwiseInverse();
  Residuals all{per_sd.cwiseProduct(theta - prior.mean), per_sd.asDiagonal()};
  if (!prior.known) return all;
  const Residuals known = prior.known(theta);
  const Index n = theta.size();
  all.r.conservativeResize(n + known.r.size());
  all.r.tail(known.r.size()) = known.r;
  all.J.conservativeResize(n + known.r.size(), n);
  all.J.bottomRows(known.r.size()) = known.J;
  return all;
}

MatrixXd known_slopes(const Prior& prior, const VectorXd& theta) {
  return prior.known ? prior.known(theta).J : MatrixXd();
}

std::optional<Minimum> minimise(const Evaluate& evaluate,
                                const Prior& prior,
                                const CountData& data,
                                const VectorXd& start,
                                const MinimiseOptions& options,
                                const OnStep& on_step) {
  Search search(evaluate, prior, options);
  std::optional<Iterate> first =
      search.first(start.cwiseMax(prior.lower).cwiseMin(prior.upper), data);
  if (!first) return std::nullopt;
  return search.go_down(std::move(*first), on_step);
}

}  // namespace tapfit::updating
