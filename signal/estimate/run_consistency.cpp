#include "signal/estimate/run_consistency.hpp"

#include "signal/statistics/tail_probability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Of 500 tests whose runs agree one is suspected.
constexpr double sure = 1.0 / 500.0;
constexpr double worth_saying = 0.01;

/// Weights of the runs.
using Contrast = Eigen::VectorXd;

/// What is made of one sensor's sums.
struct Sensor {
  CrossPowers all;
  Eigen::VectorXcd H;    ///< H1 of all hits
  double weight = 0.0;   ///< 1 over |Y|^2, and the mean over sensors
  double squares = 0.0;  ///< |Y - H F|^2, weighted
};

Sensor sensor_of(const std::vector<RunPowers>& runs, std::size_t c) {
  Sensor sensor;
  for (const RunPowers& run : runs) sensor.all += run.powers[c];
  sensor.H = estimate(sensor.all, Estimator::H1).H;
  const double share = 1.0 / static_cast<double>(runs.front().powers.size());
  sensor.weight = share / std::max(sensor.all.Gyy.sum(), 1e-300);
  const double unexplained =
      sensor.all.Gyy.sum() - sensor.H.cwiseAbs2().dot(sensor.all.Gff);
  sensor.squares = sensor.weight * std::max(unexplained, 0.0);
  return sensor;
}

// sum_{k in r} e_k F_k*, per line.
Eigen::VectorXcd residual(const CrossPowers& run, const Sensor& sensor) {
  return run.Gyf - sensor.H.cwiseProduct(run.Gff);
}

// What every run's own FRF explains, weighted.
double by_runs(const std::vector<RunPowers>& runs,
               const std::vector<Sensor>& sensors) {
  double sum = 0.0;
  for (std::size_t c = 0; c < sensors.size(); ++c) {
    for (const RunPowers& run : runs) {
      const CrossPowers& of = run.powers[c];
      sum += sensors[c].weight * residual(of, sensors[c])
                                     .cwiseAbs2()
                                     .cwiseQuotient(of.Gff.cwiseMax(1e-300))
                                     .sum();
    }
  }
  return sum;
}

// What one contrast explains beside its mean, weighted.
double by_contrast(const std::vector<RunPowers>& runs,
                   const std::vector<Sensor>& sensors,
                   const Contrast& w) {
  double sum = 0.0;
  for (std::size_t c = 0; c < sensors.size(); ++c) {
    const Eigen::VectorXd& total = sensors[c].all.Gff;
    Eigen::VectorXcd q = Eigen::VectorXcd::Zero(total.size());
    Eigen::VectorXd first = Eigen::VectorXd::Zero(total.size());
    Eigen::VectorXd second = first;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const double of = w(static_cast<Index>(r));
      q += of * residual(runs[r].powers[c], sensors[c]);
      first += of * runs[r].powers[c].Gff;
      second += of * of * runs[r].powers[c].Gff;
    }
    const Eigen::VectorXd spread =
        second - first.cwiseAbs2().cwiseQuotient(total.cwiseMax(1e-300));
    sum += sensors[c].weight *
           q.cwiseAbs2().cwiseQuotient(spread.cwiseMax(1e-300)).sum();
  }
  return sum;
}

// @param d1, d2 degrees of freedom of what is explained, and of the rest
RunInconsistency tried(RunInconsistency::Kind kind,
                       double squares,
                       double explained,
                       double d1,
                       double d2) {
  RunInconsistency found;
  found.kind = kind;
  const double rest = std::max(squares - explained, 1e-24) / d2;
  found.p_value = f_tail(explained / d1 / rest, d1, d2);
  found.change = std::sqrt(std::max(explained - d1 * rest, 0.0));
  return found;
}

/// One run's response on one sensor against the FRF of the others.
struct Against {
  double distance = 0.0;  ///< relative
  double beside = 0.0;    ///< ... once a factor is allowed for
  double factor = 1.0;
};

Against against_others(const CrossPowers& own, const CrossPowers& all) {
  const Eigen::VectorXcd H =
      (all.Gyf - own.Gyf)
          .cwiseQuotient((all.Gff - own.Gff)
                             .cwiseMax(1e-300)
                             .cast<std::complex<double>>());
  const double size = std::max(H.cwiseAbs2().dot(own.Gff), 1e-300);
  const double got = own.Gyy.sum() / size;
  Against result;
  result.factor = H.dot(own.Gyf).real() / size;
  result.distance = std::sqrt(std::max(got - 2.0 * result.factor + 1.0, 0.0));
  result.beside = std::sqrt(std::max(got - result.factor * result.factor, 0.0));
  return result;
}

double find_worst(const std::vector<RunPowers>& runs,
                  const std::vector<Sensor>& sensors,
                  RunInconsistency& found) {
  double largest = 0.0;
  for (const RunPowers& run : runs) {
    for (std::size_t c = 0; c < sensors.size(); ++c) {
      const Against one = against_others(run.powers[c], sensors[c].all);
      if (one.distance <= largest) continue;
      largest = one.distance;
      found.run = run.place;
      found.sensor = c;
      found.factor.reset();
      // A factor explains all but a fifth of the distance.
      if (one.beside < 0.2 * one.distance) found.factor = one.factor;
    }
  }
  return largest;
}

// All that is tried, each with what chance gives.
std::vector<RunInconsistency> all_tried(const std::vector<RunPowers>& runs,
                                        const std::vector<Sensor>& sensors) {
  using Kind = RunInconsistency::Kind;
  const auto m = static_cast<double>(sensors.front().all.hits);
  const auto R = static_cast<double>(runs.size());
  double squares = 0.0;
  for (const Sensor& sensor : sensors) squares += sensor.squares;
  const auto count = std::ssize(runs);
  std::vector<RunInconsistency> all{
      tried(Kind::Trend,
            squares,
            by_contrast(runs, sensors, Contrast::LinSpaced(count, -0.5, 0.5)),
            1.0,
            m - 2.0)};
  // A trend from -1/2 to 1/2 has that rms over its runs.
  all.front().change *= std::sqrt(12.0);
  for (Index r = 0; r < count && count > 2; ++r) {
    all.push_back(tried(Kind::OneApart,
                        squares,
                        by_contrast(runs, sensors, Contrast::Unit(count, r)),
                        1.0,
                        m - 2.0));
  }
  if (m > R) {
    all.push_back(tried(
        Kind::FromRunToRun, squares, by_runs(runs, sensors), R - 1.0, m - R));
  }
  return all;
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

std::optional<RunInconsistency> run_inconsistency(
    const std::vector<RunPowers>& runs) {
  if (runs.size() < 2 || runs.front().powers.empty()) return std::nullopt;
  std::vector<Sensor> sensors;
  for (std::size_t c = 0; c < runs.front().powers.size(); ++c) {
    sensors.push_back(sensor_of(runs, c));
  }
  if (sensors.front().all.hits < 3) return std::nullopt;
  const std::vector<RunInconsistency> all = all_tried(runs, sensors);
  RunInconsistency found =
      *std::ranges::min_element(all, {}, &RunInconsistency::p_value);
  found.p_value *= static_cast<double>(all.size());
  if (found.p_value > sure) return std::nullopt;
  const double distance = find_worst(runs, sensors, found);
  if (found.kind == RunInconsistency::Kind::OneApart) found.change = distance;
  if (found.change < worth_saying) return std::nullopt;
  return found;
}

Finding finding_of(const RunInconsistency& difference,
                   const acquisition::TestBundle& bundle,
                   const acquisition::RunGroup& group) {
  using Kind = RunInconsistency::Kind;
  const std::size_t worst = group.at(difference.run);
  const std::string channel =
      bundle
          .channels
              [bundle.runs[group.front()].sensors.at(difference.sensor).channel]
          .name;
  const std::string who = fmt::format(
      "run {} ({})", worst + 1, bundle.runs[worst].file.filename().string());
  const std::string size = fmt::format("{:.2g} %", 100.0 * difference.change);
  Finding finding;
  finding.what =
      fmt::format("runs {} measured the same and are averaged together, but ",
                  numbers(group));
  if (difference.kind == Kind::Trend) {
    finding.where.runs = group;
    finding.what += fmt::format(
        "their FRFs change evenly by about {} from the first to the last",
        size);
    finding.likely = "warmth, a sensor or a clamp that works loose";
    finding.remedy = "let the structure settle and measure again";
    return finding;
  }
  finding.where = {{worst}, channel, {}, {}};
  finding.what +=
      difference.kind == Kind::OneApart
          ? fmt::format("{} differs from the others by about {}", who, size)
          : fmt::format(
                "differ by about {}, more than hits of one run do; "
                "{} the most",
                size,
                who);
  if (difference.factor) {
    finding.what += fmt::format(", {} by a factor of {:.4g} and nothing else",
                                channel,
                                *difference.factor);
    finding.likely = "a range or a sensitivity was changed";
  } else {
    finding.what += fmt::format(", {} above all", channel);
    finding.likely =
        "warmth, a sensor or a clamp that works loose or a blow at another "
        "point";
  }
  finding.remedy = "leave out the runs at fault";
  return finding;
}

}  // namespace tapfit::signal
