#include "signal/checks/shared_factor.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::signal {
namespace {

constexpr double alike = 0.1;  // of logarithms
constexpr std::size_t fewest_pairs = 2;

using Point = std::pair<int, int>;  // node, component

/// What one path tells of a point.
struct PathFactor {
  std::size_t pair = 0;
  std::size_t own = 0;  // FRF whose response is the point
  double log_factor = 0.0;
};

std::map<Point, std::vector<PathFactor>> factors_by_point(
    const FrfSet& set, const std::vector<Reciprocal>& pairs) {
  std::map<Point, std::vector<PathFactor>> factors;
  const auto add = [&](std::size_t p, std::size_t own, double log_factor) {
    const Dof& at = set.frfs[own].response;
    factors[{at.node, at.component}].push_back({p, own, log_factor});
  };
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const Reciprocal& pair = pairs[p];
    const bool one_sensor =
        set.frfs[pair.frf].channel == set.frfs[pair.other].channel;
    if (pair.fair() || !pair.by_a_factor() || pair.gain <= 0.0 || one_sensor) {
      continue;
    }
    add(p, pair.frf, std::log(pair.gain));
    add(p, pair.other, -std::log(pair.gain));
  }
  return factors;
}

// Those that agree with the one in the middle.
std::vector<PathFactor> agreeing(const std::vector<PathFactor>& factors) {
  std::vector<double> logs;
  for (const PathFactor& path : factors) logs.push_back(path.log_factor);
  std::vector<PathFactor> agree = factors;
  // The lower one of two in the middle: no path tells what lies between.
  std::ranges::sort(logs);
  const double middle = logs[(logs.size() - 1) / 2];
  std::erase_if(agree, [&](const PathFactor& path) {
    return std::abs(path.log_factor - middle) > alike;
  });
  return agree;
}

SharedFactor shared(const FrfSet& set,
                    const std::vector<Reciprocal>& pairs,
                    const std::vector<PathFactor>& factors) {
  SharedFactor found;
  const PathFactor& first = factors.front();
  const Reciprocal& pair = pairs[first.pair];
  const std::size_t back = pair.frf == first.own ? pair.other : pair.frf;
  found.point = set.frfs[first.own].response;
  found.channel = set.frfs[first.own].channel;
  found.run = set.frfs[back].run;
  double sum = 0.0;
  for (const PathFactor& path : factors) {
    sum += path.log_factor;
    found.pairs.push_back(path.pair);
  }
  found.factor = std::exp(sum / static_cast<double>(factors.size()));
  return found;
}

}  // namespace

std::vector<SharedFactor> shared_factors(const FrfSet& set,
                                         const std::vector<Reciprocal>& pairs) {
  std::map<Point, std::vector<PathFactor>> open = factors_by_point(set, pairs);
  std::map<Point, double> known;  // logarithms
  std::vector<SharedFactor> found;
  while (true) {
    std::vector<PathFactor> most;
    for (const auto& [point, factors] : open) {
      if (factors.empty()) continue;
      std::vector<PathFactor> agree = agreeing(factors);
      if (agree.size() > most.size()) most = std::move(agree);
    }
    if (most.size() < fewest_pairs) return found;
    SharedFactor one = shared(set, pairs, most);
    known[{one.point.node, one.point.component}] = std::log(one.factor);
    // What is between two points that are known is told, too.
    for (auto& [point, factors] : open) {
      std::erase_if(factors, [&](const PathFactor& path) {
        const Reciprocal& pair = pairs[path.pair];
        const Dof& a = set.frfs[pair.frf].response;
        const Dof& b = set.frfs[pair.other].response;
        const auto at = [&](const Dof& dof) {
          const auto it = known.find({dof.node, dof.component});
          return it == known.end() ? 0.0 : it->second;
        };
        const bool told =
            std::abs(std::log(pair.gain) - at(a) + at(b)) <= alike;
        const bool listed = std::ranges::count(one.pairs, path.pair) > 0;
        if (told && !listed) one.pairs.push_back(path.pair);
        return told || listed;
      });
    }
    found.push_back(std::move(one));
  }
}

}  // namespace tapfit::signal
