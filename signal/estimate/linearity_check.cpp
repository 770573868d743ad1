#include "signal/estimate/linearity_check.hpp"

#include "acquisition/foundation/seeded_random.hpp"
#include "signal/estimate/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tapfit::signal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index fewest_hits = 3;
// So many that the least p-value is very strong evidence.
constexpr int permutations = 4999;
// Once so many shares were as large, more permutations would not change what
// is said.
constexpr int enough_as_large = 10;
// Hits as even as these say nothing about other levels.
constexpr double least_spread = 0.05;

// Sum over hits of (a - mean a)^2 |F|^2, the mean weighted by |F|^2; per line.
VectorXd spread_of(const MatrixXd& power, const VectorXd& level) {
  const VectorXd total = power.rowwise().sum();
  const VectorXd mean = (power * level).cwiseQuotient(total);
  return power * level.cwiseAbs2() - mean.cwiseAbs2().cwiseProduct(total);
}

VectorXd shuffled(VectorXd level, acquisition::SeededRandom& random) {
  for (Index k = level.size() - 1; k > 0; --k) {
    const auto other =
        static_cast<Index>(random.uniform(0.0, static_cast<double>(k + 1)));
    std::swap(level(k), level(std::min(other, k)));
  }
  return level;
}

// q level. Real and imaginary parts stand side by side ([complex.numbers],
// array-oriented access), so that a real product, which is faster, does for
// both.
Eigen::VectorXcd weighted(const MatrixXcd& q, const VectorXd& level) {
  Eigen::VectorXcd sum(q.rows());
  VectorXd::Map(reinterpret_cast<double*>(sum.data()), 2 * q.rows()).noalias() =
      MatrixXd::Map(
          reinterpret_cast<const double*>(q.data()), 2 * q.rows(), q.cols()) *
      level;
  return sum;
}

}  // namespace

MatrixXcd LinearityCheck::add(const Spectra& spectra) {
  const Index hits = spectra.force.cols();
  if (hits < fewest_hits || spectra.responses.empty()) return {};
  Run run;
  run.power = spectra.force.cwiseAbs2();
  run.level = run.power.colwise().mean().cwiseSqrt().transpose();
  const double low = run.level.minCoeff();
  if (!(low > 0.0) || run.level.maxCoeff() < (1.0 + least_spread) * low) {
    return {};
  }
  if (run.power.rowwise().sum().minCoeff() <= 0.0) return {};
  run.size = VectorXd::Zero(spectra.force.rows());
  for (const MatrixXcd& response : spectra.responses) {
    const Eigen::VectorXcd H =
        estimate(cross_powers(spectra.force, response), Estimator::H1).H;
    const MatrixXcd e = response - H.asDiagonal() * spectra.force;
    run.q.emplace_back(spectra.force.conjugate().cwiseProduct(e));
    run.unexplained.emplace_back(e.cwiseAbs2().rowwise().sum());
    run.size += H.cwiseAbs2();
  }
  runs_.push_back(std::move(run));
  return changes(runs_.back());
}

void LinearityCheck::add(LinearityCheck&& other) {
  std::move(other.runs_.begin(), other.runs_.end(), std::back_inserter(runs_));
}

// G range, from least squares over the hits.
MatrixXcd LinearityCheck::changes(const Run& run) {
  const VectorXd spread = spread_of(run.power, run.level).cwiseMax(1e-300);
  const double range = run.level.maxCoeff() - run.level.minCoeff();
  MatrixXcd result(run.power.rows(), static_cast<Index>(run.q.size()));
  for (Index c = 0; c < result.cols(); ++c) {
    result.col(c) =
        range *
        (run.q[static_cast<std::size_t>(c)] * run.level).cwiseQuotient(spread);
  }
  return result;
}

// |e|^2 that follows the levels, per line.
VectorXd LinearityCheck::explained(const Run& run,
                                   std::size_t sensor,
                                   const VectorXd& level,
                                   const VectorXd& spread) {
  return weighted(run.q[sensor], level)
      .cwiseAbs2()
      .cwiseQuotient(spread.cwiseMax(1e-300));
}

// Sum over lines and sensors of the share of each.
double LinearityCheck::shares(const Run& run, const VectorXd& level) {
  const VectorXd spread = spread_of(run.power, level);
  double sum = 0.0;
  for (std::size_t c = 0; c < run.q.size(); ++c) {
    sum += explained(run, c, level, spread)
               .cwiseQuotient(run.unexplained[c].cwiseMax(1e-300))
               .sum();
  }
  return sum;
}

// |dH|^2 from the weakest hit to the strongest, per line, summed over sensors.
VectorXd LinearityCheck::change_squared(const Run& run) {
  const VectorXd spread = spread_of(run.power, run.level);
  const double range = run.level.maxCoeff() - run.level.minCoeff();
  // What does not follow the level is in it as well, a hit's worth.
  const auto free = static_cast<double>(run.level.size() - 2);
  VectorXd sum = VectorXd::Zero(spread.size());
  for (std::size_t c = 0; c < run.q.size(); ++c) {
    const VectorXd follows = explained(run, c, run.level, spread);
    const VectorXd noise = (run.unexplained[c] - follows) / free;
    sum += (follows - noise).cwiseQuotient(spread.cwiseMax(1e-300));
  }
  return range * range * sum;
}

LinearityFinding LinearityCheck::finding(std::uint64_t seed) const {
  LinearityFinding result;
  result.runs = static_cast<int>(runs_.size());
  if (runs_.empty()) return result;
  double lines = 0.0;
  double own = 0.0;
  VectorXd square = VectorXd::Zero(runs_.front().size.size());
  VectorXd size = square;
  for (const Run& run : runs_) {
    own += shares(run, run.level);
    lines += static_cast<double>(run.power.rows()) *
             static_cast<double>(run.q.size());
    square += change_squared(run);
    size += run.size;
    result.level_ratio += (run.level.maxCoeff() / run.level.minCoeff() - 1.0) /
                          static_cast<double>(runs_.size());
  }
  result.share = own / lines;
  result.change = std::sqrt(std::max(square.cwiseQuotient(size).mean(), 0.0));
  acquisition::SeededRandom random(seed, "levels");
  int as_large = 0;
  int tried = 0;
  while (tried < permutations && as_large < enough_as_large) {
    double sum = 0.0;
    for (const Run& run : runs_) {
      sum += shares(run, shuffled(run.level, random));
    }
    ++tried;
    result.share_by_chance += (sum / lines - result.share_by_chance) / tried;
    if (sum >= own) ++as_large;
  }
  result.p_value = tried < permutations
                       ? static_cast<double>(as_large) / tried
                       : (as_large + 1.0) / (permutations + 1.0);
  return result;
}

}  // namespace tapfit::signal
