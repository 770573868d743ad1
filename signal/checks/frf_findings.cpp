#include "signal/checks/frf_findings.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace tapfit::signal {
namespace {

using acquisition::TestBundle;
using Eigen::Index;

// A sensor's incoherence that is worth a word: that much, and so many times
// what the run's other sensors have.
constexpr double much_incoherence = 0.05;
constexpr double against_others = 5.0;
constexpr double much_spread = 0.1;

std::string file_of(const TestBundle& bundle, std::size_t run) {
  return bundle.runs.at(run).file.filename().string();
}

// "run-01.wav and 4 more".
std::string files_of(const TestBundle& bundle,
                     const acquisition::RunGroup& group) {
  const std::string first = file_of(bundle, group.front());
  return group.size() == 1
             ? first
             : fmt::format("{} and {} more", first, group.size() - 1);
}

// Mean incoherence of each sensor over the pairs of hits that are kept.
Eigen::VectorXd sensor_incoherence(const HitCoherence& of) {
  const std::vector<HitAt> apart = hits_apart(of);
  const auto n = static_cast<Index>(of.hits.size());
  Eigen::VectorXd result(static_cast<Index>(of.pairs.size()));
  const auto kept = [&](Index k) {
    return !std::ranges::binary_search(apart,
                                       of.hits[static_cast<std::size_t>(k)]);
  };
  for (Index c = 0; c < result.size(); ++c) {
    const Eigen::MatrixXd& pairs = of.pairs[static_cast<std::size_t>(c)];
    double sum = 0.0;
    int count = 0;
    for (Index i = 0; i < n; ++i) {
      for (Index j = i + 1; j < n; ++j) {
        if (!kept(i) || !kept(j)) continue;
        sum += 1.0 - pairs(i, j);
        ++count;
      }
    }
    result(c) = count > 0 ? sum / count : 0.0;
  }
  return result;
}

double median_without(const Eigen::VectorXd& values, Index one) {
  std::vector<double> others;
  for (Index i = 0; i < values.size(); ++i) {
    if (i != one) others.push_back(values(i));
  }
  return acquisition::median(others);
}

// The name of the hammer's channel; of ready FRFs "the hammer".
std::string hammer_of(const TestBundle& bundle, const Frf& frf) {
  return frf.run < bundle.runs.size()
             ? bundle.channels[bundle.runs[frf.run].hammer.channel].name
             : "the hammer";
}

// Whether all driving points are turned that say anything, on two sensors and
// more: then the hammer is.
bool hammer_turned(const FrfSet& set, const std::vector<DrivingPoint>& points) {
  std::set<std::size_t> channels;
  for (const DrivingPoint& p : points) {
    if (p.peaks == 0) continue;
    if (!p.turned() || p.rather) return false;
    channels.insert(set.frfs[p.frf].channel);
  }
  return channels.size() > 1;
}

Finding turned_finding(const TestBundle& bundle,
                       const FrfSet& set,
                       const DrivingPoint& point,
                       bool hammer) {
  const Frf& frf = set.frfs[point.frf];
  Subject where = subject_of(bundle, frf);
  if (hammer) where.channel = hammer_of(bundle, frf);
  return {Severity::Warning,
          std::move(where),
          fmt::format("{}: {} of {} peaks point down",
                      titled(bundle, frf),
                      point.wrong_peaks,
                      point.peaks),
          hammer ? "the polarity of the hammer is turned (all driving points "
                   "are)"
                 : fmt::format("the polarity of {} is turned",
                               channel_of(bundle, frf)),
          hammer ? "turn the hammer's direction in test.json, or make its "
                   "sensitivity negative"
                 : "turn the sensor's direction in test.json, or make its "
                   "sensitivity negative"};
}

Finding swapped_finding(const TestBundle& bundle,
                        const FrfSet& set,
                        const DrivingPoint& point) {
  const Frf& frf = set.frfs[point.frf];
  const Frf& other = set.frfs[*point.rather];
  const std::string one = channel_of(bundle, frf);
  const std::string two = channel_of(bundle, other);
  Finding finding;
  finding.where = subject_of(bundle, frf);
  finding.what = fmt::format(
      "{} is no driving point ({} of {} peaks point down, active at {:.0f} % "
      "of the lines), but what {} recorded would be one",
      titled(bundle, frf),
      point.wrong_peaks,
      point.peaks,
      100.0 * point.active_share,
      two);
  const std::string blow = fmt::format(
      "the blow was at {}, or the file is another run's: files in "
      "another order than `runs`",
      name(other.response));
  switch (point.wrong) {
    case WrongLabel::Channel:
      finding.severity = Severity::Error;
      finding.likely =
          fmt::format("{} and {} are swapped in this run", one, two);
      finding.remedy = "exchange the two in the run's `sensors` in test.json";
      break;
    case WrongLabel::Blow:
      finding.what += "; the sensors agree with those of the other runs";
      finding.likely = blow;
      finding.remedy =
          "compare the order of files with the sheet, and correct `file` or "
          "`hammer` of this run and those after it in test.json";
      break;
    case WrongLabel::Either:
      finding.likely =
          fmt::format("{} and {} are swapped, or {}", one, two, blow);
      finding.remedy =
          "exchange the two in test.json, or at the front end; or correct the "
          "run's `file` or `hammer`";
      break;
  }
  return finding;
}

Finding driving_point_finding(const TestBundle& bundle,
                              const FrfSet& set,
                              const DrivingPoint& point,
                              bool hammer) {
  if (point.rather) return swapped_finding(bundle, set, point);
  if (point.turned()) return turned_finding(bundle, set, point, hammer);
  const Frf& frf = set.frfs[point.frf];
  if (point.wrong_peaks > 0) {
    return {Severity::Warning,
            subject_of(bundle, frf),
            fmt::format("{}: {} of {} peaks point down, which no driving "
                        "point does",
                        titled(bundle, frf),
                        point.wrong_peaks,
                        point.peaks),
            "hammer and sensor were not at one point or not in one direction",
            "correct the point in test.json, or leave the FRF out of modal "
            "scaling"};
  }
  return {Severity::Warning,
          subject_of(bundle, frf),
          fmt::format("{}: the structure would give energy away at {:.0f} % of "
                      "the lines",
                      titled(bundle, frf),
                      100.0 * point.active_share),
          "one channel lags behind the other, or the sensor is not where the "
          "hammer hit",
          "correct the point in test.json, or give both channels the same "
          "filter and converter; the diagnosis takes a delay in as "
          "channel-delay"};
}

}  // namespace

std::string channel_of(const TestBundle& bundle, const Frf& frf) {
  return frf.channel < bundle.channels.size()
             ? bundle.channels[frf.channel].name
             : "the sensor at " + name(frf.response);
}

std::string titled(const TestBundle& bundle, const Frf& frf) {
  return frf.channel < bundle.channels.size()
             ? name(frf) + " (" + channel_of(bundle, frf) + ")"
             : name(frf);
}

Subject subject_of(const TestBundle& bundle, const Frf& frf) {
  return {{frf.run}, channel_of(bundle, frf), {}, name(frf)};
}

std::vector<Finding> coherence_findings(const TestBundle& bundle,
                                        const HitCoherence& of,
                                        const acquisition::RunGroup& group) {
  std::vector<Finding> found;
  for (const HitAt& at : hits_apart(of)) {
    found.push_back({Severity::Note,
                     {{at.run}, {}, at.hit, {}},
                     fmt::format("{}: hit {} stands apart from the others",
                                 file_of(bundle, at.run),
                                 at.hit + 1),
                     "it fell beside the point or was a double one",
                     "frf --best-hits leaves it out, or overrule it by hand"});
  }
  if (of.hits.size() < 2) return found;
  const Eigen::VectorXd u = sensor_incoherence(of);
  for (Index c = 0; c < u.size(); ++c) {
    const double limit =
        std::max(much_incoherence, against_others * median_without(u, c));
    if (u(c) <= limit) continue;
    const auto& sensor =
        bundle.runs[group.front()].sensors.at(static_cast<std::size_t>(c));
    found.push_back(
        {Severity::Note,
         {{group.begin(), group.end()},
          bundle.channels.at(sensor.channel).name,
          {},
          {}},
         fmt::format("{}: {} agrees with itself from hit to hit to {:.3f} only",
                     files_of(bundle, group),
                     bundle.channels.at(sensor.channel).name,
                     1.0 - u(c)),
         "a loose mounting, cable or range; where the structure hardly moves, "
         "noise and no fault",
         "look at its mounting, cable and range"});
  }
  return found;
}

std::vector<Finding> driving_point_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<DrivingPoint>& points) {
  const bool hammer = hammer_turned(set, points);
  std::vector<Finding> found;
  for (const DrivingPoint& point : points) {
    if (point.fair()) continue;
    found.push_back(driving_point_finding(bundle, set, point, hammer));
  }
  return found;
}

std::vector<Finding> spread_findings(const FrfSet& set) {
  const Frf* worst = nullptr;
  double largest = much_spread;
  int count = 0;
  for (const Frf& frf : set.frfs) {
    const double spread = spread_at_peaks(frf).value_or(0.0);
    if (spread <= much_spread) continue;
    ++count;
    if (spread > largest) {
      largest = spread;
      worst = &frf;
    }
  }
  if (worst == nullptr) return {};
  return {{Severity::Note,
           {{worst->run}, {}, {}, name(*worst)},
           fmt::format("H2 lies more than 10 % over H1 at peaks of {} FRFs, "
                       "most in {} (run {}): {:.3g} %",
                       count,
                       name(*worst),
                       worst->run + 1,
                       100.0 * largest),
           "noise on force or response, or hits that do not repeat",
           "leave out hits of low coherence, take more of them or a longer "
           "block; with noise on the force, frf --estimator Hv"}};
}

}  // namespace tapfit::signal
