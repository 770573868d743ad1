#include "acquisition/checks/tip_change.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tapfit::acquisition {
namespace {

struct RunBlow {
  std::size_t run = 0;
  double length_s = 0.0;
};

std::vector<RunBlow> blows_of(const HitSet& hits) {
  std::vector<RunBlow> blows;
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    std::vector<double> lengths;
    for (const Hit& hit : hits.runs[r]) {
      if (hit.accepted) lengths.push_back(hit.pulse_s);
    }
    if (!lengths.empty()) blows.push_back({r, median(std::move(lengths))});
  }
  return blows;
}

double median_of(std::span<const RunBlow> blows) {
  std::vector<double> lengths;
  for (const RunBlow& blow : blows) lengths.push_back(blow.length_s);
  return median(std::move(lengths));
}

// The shortest of one part over the longest of the other.
double gap(std::span<const RunBlow> longer, std::span<const RunBlow> shorter) {
  return std::ranges::min(longer, {}, &RunBlow::length_s).length_s /
         std::ranges::max(shorter, {}, &RunBlow::length_s).length_s;
}

// The envelope: below the first zero the spectrum itself.
double level(double hz, double length_s) {
  // sin(pi x) = 0.1 at both ends of what is seen of the half sine.
  const double seen = 1.0 - 2.0 * std::asin(0.1) / std::numbers::pi;
  const double x = 2.0 * hz * length_s / seen;
  if (x < 1e-6) return 1.0;
  const double top = std::abs(1.0 - x * x);
  const double wave = std::abs(std::cos(0.5 * std::numbers::pi * x));
  // Half a lobe from the removable zero at x = 1 on, lobes follow.
  constexpr double lobes_from = 2.0;
  if (x >= lobes_from) return 1.0 / top;
  return top < 1e-6 ? 0.25 * std::numbers::pi : wave / top;
}

}  // namespace

std::optional<TipChange> tip_change(const HitSet& hits) {
  constexpr std::size_t fewest = 5;
  constexpr std::size_t fewest_of_part = 2;
  constexpr double clearly = 1.3;
  const std::vector<RunBlow> blows = blows_of(hits);
  if (blows.size() < fewest) return {};
  const std::span<const RunBlow> all(blows);
  std::optional<TipChange> found;
  double widest = clearly;
  for (std::size_t k = fewest_of_part; k + fewest_of_part <= all.size(); ++k) {
    const auto before = all.first(k);
    const auto after = all.subspan(k);
    const double apart = std::max(gap(after, before), gap(before, after));
    if (apart < widest) continue;
    widest = apart;
    found = {after.front().run, median_of(before), median_of(after)};
  }
  return found;
}

double force_lost_db(double hz, double length_s, double other_s) {
  return 20.0 * std::log10(level(hz, other_s) / level(hz, length_s));
}

std::vector<Finding> tip_change_findings(const TestBundle& bundle,
                                         const HitSet& hits) {
  const auto change = tip_change(hits);
  if (!change) return {};
  const double high =
      bundle.band_hz ? bundle.band_hz->at(1) : hits.usable_bandwidth_hz;
  const bool softer = change->after_s > change->before_s;
  const double lost =
      std::abs(force_lost_db(high, change->after_s, change->before_s));
  constexpr double much_db = 10.0;
  Subject where;
  for (std::size_t r = change->first; r < hits.runs.size(); ++r) {
    where.runs.push_back(r);
  }
  return {{lost > much_db ? Severity::Warning : Severity::Note,
           std::move(where),
           fmt::format("the blows last {:.2g} ms from run {} on, {:.2g} ms in "
                       "the runs before: {:.2g} dB {} force at {:.4g} Hz",
                       1e3 * change->after_s,
                       change->first + 1,
                       1e3 * change->before_s,
                       lost,
                       softer ? "less" : "more",
                       high),
           fmt::format("a {} tip, another hammer, or points that give {}",
                       softer ? "softer" : "harder",
                       softer ? "more" : "less"),
           "hit all points with one tip, or let band_hz end where the softer "
           "one still gives force"}};
}

}  // namespace tapfit::acquisition
