#include "acquisition/checks/one_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::acquisition {
namespace {

constexpr double least_alike = 0.87;
constexpr double most_apart = 2.0;

// How two signals go together.
struct Likeness {
  double r = 1.0;
  double ratio = 1.0;  ///< of the levels, of the second to the first

  [[nodiscard]] bool is_one_motion() const {
    return r >= least_alike && ratio <= most_apart && ratio * most_apart >= 1.0;
  }
};

Likeness likeness_of(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  constexpr double loud = 0.2;
  const double x_level = loud * x.cwiseAbs().maxCoeff();
  const double y_level = loud * y.cwiseAbs().maxCoeff();
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (std::abs(x[i]) < x_level && std::abs(y[i]) < y_level) continue;
    xx += x[i] * x[i];
    yy += y[i] * y[i];
    xy += x[i] * y[i];
  }
  // A channel that is silent is named as such.
  if (!(xx > 0.0) || !(yy > 0.0)) return {};
  return {xy / std::sqrt(xx * yy), std::sqrt(yy / xx)};
}

Likeness likeness_in(const Recording& recording,
                     const Placement& one,
                     const Placement& other) {
  const auto of = [&](const Placement& sensor) -> Eigen::VectorXd {
    const Eigen::VectorXd x =
        recording.samples.col(static_cast<Eigen::Index>(sensor.channel));
    return sensor.dof.sign * (x.array() - x.mean());
  };
  return likeness_of(of(one), of(other));
}

struct Pair {
  Placement one;
  Placement other;
  std::vector<std::size_t> runs;
  Likeness worst;  ///< by r
};

std::string seen(const Likeness& like) {
  if (like.r <= -least_alike) return "move against each other";
  if (std::abs(like.r) < least_alike) {
    return fmt::format("hold different signals (their correlation is {:.2f})",
                       like.r);
  }
  return fmt::format("differ by a factor of {}", in_digits(like.ratio, 2));
}

Finding finding_of(const TestBundle& bundle, Pair pair) {
  const std::string& one = bundle.channels[pair.one.channel].name;
  const std::string& other = bundle.channels[pair.other.channel].name;
  return {Severity::Warning,
          {std::move(pair.runs), other, {}, name(pair.other.dof)},
          fmt::format("{} and {} are at one point and direction and {}",
                      one,
                      other,
                      seen(pair.worst)),
          "the point or direction of one of them is wrong, or its sensitivity",
          fmt::format("correct `node` or `direction` of {} or {} in `sensors`, "
                      "or leave one of the two out",
                      one,
                      other)};
}

bool share_a_point(const TestBundle& bundle,
                   const Placement& one,
                   const Placement& other) {
  return one.channel != other.channel && one.dof.node == other.dof.node &&
         one.dof.component == other.dof.component &&
         bundle.channels[one.channel].quantity ==
             bundle.channels[other.channel].quantity;
}

}  // namespace

std::vector<Finding> one_point_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings) {
  std::map<std::pair<std::size_t, std::size_t>, Pair> apart;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    if (recordings[r].samples.rows() == 0) continue;
    const std::vector<Placement>& sensors = bundle.runs[r].sensors;
    for (auto one = sensors.begin(); one != sensors.end(); ++one) {
      for (auto other = one + 1; other != sensors.end(); ++other) {
        if (!share_a_point(bundle, *one, *other)) continue;
        const Likeness like = likeness_in(recordings[r], *one, *other);
        if (like.is_one_motion()) continue;
        Pair& pair = apart
                         .try_emplace({one->channel, other->channel},
                                      Pair{*one, *other, {}, like})
                         .first->second;
        pair.runs.push_back(r);
        if (like.r < pair.worst.r) pair.worst = like;
      }
    }
  }
  std::vector<Finding> findings;
  for (auto& [channels, pair] : apart) {
    findings.push_back(finding_of(bundle, std::move(pair)));
  }
  return findings;
}

}  // namespace tapfit::acquisition
