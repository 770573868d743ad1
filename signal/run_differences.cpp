#include "signal/run_differences.hpp"

#include "signal/estimator.hpp"
#include "signal/f_tail.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

// Of 500 tests whose runs agree one is suspected.
constexpr double sure = 1.0 / 500.0;
constexpr double worth_saying = 0.01;

/// Weights of the hits, one column for each thing that may explain e.
using Contrasts = Eigen::MatrixXd;

// One for each run that has a hit.
Contrasts by_run(const std::vector<std::size_t>& run,
                 const std::vector<std::size_t>& place) {
  Contrasts of = Contrasts::Zero(std::ssize(run), std::ssize(place));
  for (std::size_t k = 0; k < run.size(); ++k) {
    const auto column = std::ranges::find(place, run[k]) - place.begin();
    of(static_cast<Index>(k), column) = 1.0;
  }
  return of;
}

Contrasts by_order(Index hits) {
  return Eigen::VectorXd::LinSpaced(hits, -0.5, 0.5);
}

/// Squares relative to those of the response, mean over sensors.
struct Squares {
  double all = 0.0;        ///< |Y - H F|^2
  double explained = 0.0;  ///< of these
};

// Per line, sum over hits of (w - mean w)^2 |F|^2, the mean weighted by |F|^2.
Eigen::VectorXd spread_of(const Eigen::MatrixXd& power,
                          const Eigen::VectorXd& w) {
  const Eigen::VectorXd total = power.rowwise().sum().cwiseMax(1e-300);
  const Eigen::VectorXd sum = power * w;
  return (power * w.cwiseAbs2() - sum.cwiseAbs2().cwiseQuotient(total))
      .cwiseMax(1e-300);
}

// The residuals e do not hold the mean, so that one column explains what it
// does beside the mean, and all runs' columns together what these do.
Squares squares(const Spectra& spectra, const Contrasts& of) {
  Squares sum;
  const double share = 1.0 / static_cast<double>(spectra.responses.size());
  const Eigen::MatrixXd power = spectra.force.cwiseAbs2();
  for (const MatrixXcd& Y : spectra.responses) {
    const Eigen::VectorXcd H =
        estimate(cross_powers(spectra.force, Y), Estimator::H1).H;
    const MatrixXcd e = Y - H.asDiagonal() * spectra.force;
    const MatrixXcd q = spectra.force.conjugate().cwiseProduct(e);
    const double weight = share / std::max(Y.squaredNorm(), 1e-300);
    sum.all += weight * e.squaredNorm();
    for (Index c = 0; c < of.cols(); ++c) {
      const Eigen::VectorXd spread =
          of.cols() == 1
              ? spread_of(power, of.col(c))
              : Eigen::VectorXd((power * of.col(c)).cwiseMax(1e-300));
      sum.explained +=
          weight * (q * of.col(c)).cwiseAbs2().cwiseQuotient(spread).sum();
    }
  }
  return sum;
}

// @param d1, d2 degrees of freedom of what is explained, and of the rest
RunDifference tried(const Spectra& spectra,
                    const Contrasts& of,
                    RunDifference::Kind kind,
                    double d1,
                    double d2) {
  RunDifference found;
  found.kind = kind;
  const Squares sum = squares(spectra, of);
  const double rest = std::max(sum.all - sum.explained, 1e-24) / d2;
  found.p_value = f_tail(sum.explained / d1 / rest, d1, d2);
  found.change = std::sqrt(std::max(sum.explained - d1 * rest, 0.0));
  return found;
}

/// One run's response on one sensor against the FRF of the others.
struct Against {
  double distance = 0.0;  ///< relative
  double beside = 0.0;    ///< ... once a factor is allowed for
  double factor = 1.0;
};

Against against_others(const Spectra& spectra,
                       std::size_t sensor,
                       const Eigen::VectorXd& own) {
  const MatrixXcd& F = spectra.force;
  const MatrixXcd& Y = spectra.responses[sensor];
  const Eigen::VectorXd others = 1.0 - own.array();
  const Eigen::VectorXcd H =
      ((Y.cwiseProduct(F.conjugate())) * others)
          .cwiseQuotient((F.cwiseAbs2() * others).cwiseMax(1e-300));
  const MatrixXcd expected = H.asDiagonal() * F * own.asDiagonal();
  const MatrixXcd got = Y * own.asDiagonal();
  const double size = std::max(expected.squaredNorm(), 1e-300);
  Against result;
  result.factor = expected.conjugate().cwiseProduct(got).sum().real() / size;
  result.distance = std::sqrt((got - expected).squaredNorm() / size);
  result.beside =
      std::sqrt((got - result.factor * expected).squaredNorm() / size);
  return result;
}

// @param place of each column's run in the group
double find_worst(const Spectra& spectra,
                  const Contrasts& runs,
                  const std::vector<std::size_t>& place,
                  RunDifference& found) {
  double largest = 0.0;
  for (Index r = 0; r < runs.cols(); ++r) {
    for (std::size_t c = 0; c < spectra.responses.size(); ++c) {
      const Against one = against_others(spectra, c, runs.col(r));
      if (one.distance <= largest) continue;
      largest = one.distance;
      found.run = place[static_cast<std::size_t>(r)];
      found.sensor = c;
      found.factor.reset();
      // A factor explains all but a fifth of the distance.
      if (one.beside < 0.2 * one.distance) found.factor = one.factor;
    }
  }
  return largest;
}

// "1, 2 and 5".
std::string numbers(const acquisition::RunGroup& group) {
  std::vector<std::size_t> from_one;
  for (const std::size_t r : group) from_one.push_back(r + 1);
  const std::size_t last = from_one.back();
  from_one.pop_back();
  return fmt::format("{} and {}", fmt::join(from_one, ", "), last);
}

}  // namespace

std::optional<RunDifference> run_difference(
    const Spectra& spectra, const std::vector<std::size_t>& run) {
  using Kind = RunDifference::Kind;
  const auto hits = static_cast<Index>(run.size());
  if (hits < 3 || run.front() == run.back()) return std::nullopt;
  if (spectra.responses.empty()) return std::nullopt;
  std::vector<std::size_t> place = run;
  place.erase(std::ranges::unique(place).begin(), place.end());
  const Contrasts runs = by_run(run, place);
  const auto m = static_cast<double>(hits);
  const auto R = static_cast<double>(runs.cols());
  std::vector<RunDifference> all{
      tried(spectra, by_order(hits), Kind::Trend, 1.0, m - 2.0)};
  // A trend from -1/2 to 1/2 has that rms over its hits.
  all.front().change *= std::sqrt(12.0);
  for (Index r = 0; r < runs.cols() && runs.cols() > 2; ++r) {
    all.push_back(tried(spectra, runs.col(r), Kind::OneApart, 1.0, m - 2.0));
  }
  if (m > R) {
    all.push_back(tried(spectra, runs, Kind::FromRunToRun, R - 1.0, m - R));
  }
  RunDifference found =
      *std::ranges::min_element(all, {}, &RunDifference::p_value);
  found.p_value *= static_cast<double>(all.size());
  if (found.p_value > sure) return std::nullopt;
  const double distance = find_worst(spectra, runs, place, found);
  if (found.kind == Kind::OneApart) found.change = distance;
  if (found.change < worth_saying) return std::nullopt;
  return found;
}

std::string statement(const RunDifference& difference,
                      const acquisition::TestBundle& bundle,
                      const acquisition::RunGroup& group) {
  using Kind = RunDifference::Kind;
  const std::size_t worst = group.at(difference.run);
  const std::string channel =
      bundle
          .channels
              [bundle.runs[group.front()].sensors.at(difference.sensor).channel]
          .name;
  const std::string who = fmt::format(
      "run {} ({})", worst + 1, bundle.runs[worst].file.filename().string());
  const std::string size = fmt::format("{:.2g} %", 100.0 * difference.change);
  std::string text =
      fmt::format("runs {} measured the same and are averaged together, but ",
                  numbers(group));
  if (difference.kind == Kind::Trend) {
    return text + fmt::format(
                      "their FRFs change evenly by about {} from the first to "
                      "the last: look for warmth, a sensor or a clamp that "
                      "works loose",
                      size);
  }
  text += difference.kind == Kind::OneApart
              ? fmt::format("{} differs from the others by about {}", who, size)
              : fmt::format(
                    "differ by about {}, more than hits of one run do; "
                    "{} the most",
                    size,
                    who);
  if (difference.factor) {
    return text + fmt::format(
                      ", {} by a factor of {:.4g} and nothing else: was "
                      "a range or a sensitivity changed? Leave out the "
                      "runs at fault",
                      channel,
                      *difference.factor);
  }
  return text + fmt::format(
                    ", {} above all: look for warmth, a sensor or a "
                    "clamp that works loose or a blow at another point, "
                    "and leave out the runs at fault",
                    channel);
}

}  // namespace tapfit::signal
