#include "signal/checks/quality_findings.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

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
  if (others.empty()) return 0.0;
  return acquisition::median(
      Eigen::VectorXd::Map(others.data(), static_cast<Index>(others.size())));
}

// Whether all driving points are turned that say anything, on two sensors and
// more: then the hammer is.
bool hammer_turned(const FrfSet& set, const std::vector<DrivingPoint>& points) {
  std::set<std::size_t> channels;
  for (const DrivingPoint& p : points) {
    if (p.peaks == 0) continue;
    if (!p.turned()) return false;
    channels.insert(set.frfs[p.frf].channel);
  }
  return channels.size() > 1;
}

QualityFinding turned_finding(const std::string& who,
                              const DrivingPoint& point,
                              const std::string& sensor,
                              bool hammer) {
  return {fmt::format("{}: {} of {} peaks point down, the polarity of {} is "
                      "inverted",
                      who,
                      point.wrong_peaks,
                      point.peaks,
                      hammer ? "the hammer (all driving points are)" : sensor),
          hammer ? "turn the hammer's direction in test.json, or make its "
                   "sensitivity negative"
                 : "turn the sensor's direction in test.json, or make its "
                   "sensitivity negative"};
}

QualityFinding driving_point_finding(const TestBundle& bundle,
                                     const FrfSet& set,
                                     const DrivingPoint& point,
                                     bool hammer) {
  const Frf& frf = set.frfs[point.frf];
  const std::string who = titled(bundle, frf);
  if (point.rather) {
    const Frf& other = set.frfs[*point.rather];
    return {fmt::format("{} is no driving point ({} of {} peaks point down, "
                        "active at {:.0f} % of the lines), but what {} "
                        "recorded would be one",
                        who,
                        point.wrong_peaks,
                        point.peaks,
                        100.0 * point.active_share,
                        channel_of(bundle, other)),
            fmt::format("see whether {} and {} are swapped, in test.json or at "
                        "the front end",
                        channel_of(bundle, frf),
                        channel_of(bundle, other))};
  }
  if (point.turned()) {
    return turned_finding(who, point, channel_of(bundle, frf), hammer);
  }
  if (point.wrong_peaks > 0) {
    return {fmt::format("{}: {} of {} peaks point down, which no driving point "
                        "does",
                        who,
                        point.wrong_peaks,
                        point.peaks),
            "hammer and sensor were not at one point or not in one direction: "
            "correct the point in test.json, or leave the FRF out of modal "
            "scaling"};
  }
  return {fmt::format("{}: the structure would give energy away at {:.0f} % of "
                      "the lines",
                      who,
                      100.0 * point.active_share),
          "one channel lags behind the other, or the sensor is not where the "
          "hammer hit: tapfit calibrate on a free mass gives the delay"};
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

std::vector<QualityFinding> coherence_findings(
    const TestBundle& bundle,
    const HitCoherence& of,
    const acquisition::RunGroup& group) {
  std::vector<QualityFinding> found;
  for (const HitAt& at : hits_apart(of)) {
    found.push_back(
        {fmt::format("{}: hit {} stands apart from the others",
                     file_of(bundle, at.run),
                     at.hit + 1),
         "it fell beside the point or was a double one: frf --best-hits leaves "
         "it out, or overrule it by hand"});
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
        {fmt::format("{}: {} agrees with itself from hit to hit to {:.3f} only",
                     files_of(bundle, group),
                     bundle.channels.at(sensor.channel).name,
                     1.0 - u(c)),
         "look at its mounting, cable and range; if it sits where the "
         "structure hardly moves, this is noise and no fault"});
  }
  return found;
}

std::vector<QualityFinding> driving_point_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<DrivingPoint>& points) {
  const bool hammer = hammer_turned(set, points);
  std::vector<QualityFinding> found;
  for (const DrivingPoint& point : points) {
    if (point.fair()) continue;
    found.push_back(driving_point_finding(bundle, set, point, hammer));
  }
  return found;
}

std::vector<QualityFinding> reciprocity_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Reciprocal>& pairs) {
  std::vector<QualityFinding> found;
  for (const Reciprocal& pair : pairs) {
    if (pair.fair()) continue;
    const Frf& a = set.frfs[pair.frf];
    const Frf& b = set.frfs[pair.other];
    const std::string both = titled(bundle, a) + " and " + titled(bundle, b);
    // A factor explains all but a tenth of the difference.
    const bool factor = pair.shape_difference < 0.1 * pair.difference ||
                        pair.shape_difference < 0.02;
    if (factor && pair.gain < 0.0) {
      found.push_back(
          {both + " have opposite signs",
           "turn the direction of one of the two sensors in test.json; a "
           "driving point says which"});
    } else if (factor && channel_of(bundle, a) == channel_of(bundle, b)) {
      found.push_back(
          {fmt::format("{} differ by a factor of {:.4g} and nothing else, "
                       "though one sensor measured both",
                       both,
                       pair.gain),
           "its range or the hammer's was changed between the two runs: give "
           "each run the sensitivity it was measured with"});
    } else if (factor) {
      found.push_back(
          {fmt::format("{} differ by a factor of {:.4g} and nothing else",
                       both,
                       pair.gain),
           "one of the two sensitivities is off by it: tapfit calibrate on a "
           "free mass says which"});
    } else {
      found.push_back(
          {fmt::format("{} differ by {:.3g} %, whatever the factor",
                       both,
                       100.0 * pair.shape_difference),
           "a point or direction is another one than written down, a sensor "
           "that moved has shifted the resonances (tapfit modes tells its "
           "mass), or hits of differing strength move a structure that is not "
           "linear"});
    }
  }
  return found;
}

std::vector<QualityFinding> spread_findings(const FrfSet& set) {
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
  return {{fmt::format("H2 lies more than 10 % over H1 at peaks of {} FRFs, "
                       "most in {} (run {}): {:.3g} %",
                       count,
                       name(*worst),
                       worst->run + 1,
                       100.0 * largest),
           "leave out hits of low coherence, take more of them or a longer "
           "block; with noise on the force, frf --estimator Hv"}};
}

}  // namespace tapfit::signal
