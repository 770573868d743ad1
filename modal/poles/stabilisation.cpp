#include "modal/poles/stabilisation.hpp"

#include "modal/mode_set/mac.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

double damping(const Complex& pole) { return -pole.real() / std::abs(pole); }

/// Keeps what a structure can have: damped, in the widened band.
OrderPoles admissible(const OrderPoles& all,
                      double low,
                      double high,
                      double max_damping) {
  std::vector<Index> keep;
  for (Index p = 0; p < all.poles.size(); ++p) {
    const double omega = std::abs(all.poles(p));
    const double zeta = damping(all.poles(p));
    if (omega > low && omega < high && zeta > 0.0 && zeta < max_damping) {
      keep.push_back(p);
    }
  }
  OrderPoles result;
  result.order = all.order;
  result.poles = all.poles(keep);
  result.participation = all.participation(Eigen::all, keep);
  return result;
}

/// Compares a pole with the nearest one of the order before.
char letter(const OrderPoles& now,
            Index p,
            const OrderPoles& before,
            const IdentifyOptions& options) {
  if (before.poles.size() == 0) return 'o';
  const Complex pole = now.poles(p);
  Index nearest = 0;
  (before.poles.array() - pole).abs().minCoeff(&nearest);
  const Complex other = before.poles(nearest);
  const double df = std::abs(std::abs(pole) / std::abs(other) - 1.0);
  if (df > options.frequency_tolerance) return 'o';
  const bool same_damping = std::abs(damping(pole) - damping(other)) <=
                            options.damping_tolerance * damping(other);
  const bool same_vector = 1.0 - mac(now.participation.col(p),
                                     before.participation.col(nearest))(0, 0) <=
                           options.vector_tolerance;
  if (same_damping && same_vector) return 's';
  if (same_damping) return 'd';
  return same_vector ? 'v' : 'f';
}

/// A track and a pole that may continue it.
struct Link {
  double distance = 0.0;
  std::size_t track = 0;
  Index pole = 0;
};

constexpr int longest_gap = 3;  // orders a track may miss and still go on

std::vector<Link> possible_links(const std::vector<Track>& tracks,
                                 const std::vector<int>& last_seen,
                                 int position,
                                 const OrderPoles& now,
                                 double tolerance) {
  std::vector<Link> links;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (position - last_seen[t] > longest_gap) continue;
    const Complex last = tracks[t].poles.back();
    for (Index p = 0; p < now.poles.size(); ++p) {
      const double distance = std::abs(now.poles(p) - last) / std::abs(last);
      if (distance > tolerance) continue;
      const double vectors =
          mac(now.participation.col(p), tracks[t].participation)(0, 0);
      if (vectors < 0.5) continue;
      // Half a tolerance further away for a vector that is quite different.
      links.push_back({distance + 0.5 * tolerance * (1.0 - vectors), t, p});
    }
  }
  std::ranges::sort(links, {}, &Link::distance);
  return links;
}

void start_track(std::vector<Track>& tracks,
                 const OrderPoles& now,
                 Index pole) {
  Track track;
  track.orders = {now.order};
  track.poles = {now.poles(pole)};
  track.participation = now.participation.col(pole);
  tracks.push_back(std::move(track));
}

void extend_track(Track& track, const OrderPoles& now, const Link& link) {
  track.orders.push_back(now.order);
  track.poles.push_back(now.poles(link.pole));
  track.participation = now.participation.col(link.pole);
}

/// The pole with the smallest sum of distances to the others.
Complex medoid(const std::vector<Complex>& poles) {
  Complex best = poles.front();
  double least = std::numeric_limits<double>::max();
  for (const Complex& candidate : poles) {
    double sum = 0.0;
    for (const Complex& other : poles) sum += std::abs(candidate - other);
    if (sum < least) std::tie(least, best) = std::tuple(sum, candidate);
  }
  return best;
}

void summarise(Track& track,
               const std::vector<int>& positions,
               int count,
               const IdentifyOptions& options) {
  track.pole = medoid(track.poles);
  for (std::size_t k = 1; k < track.poles.size(); ++k) {
    const double df =
        std::abs(std::abs(track.poles[k]) / std::abs(track.poles[k - 1]) - 1.0);
    const double change =
        std::abs(damping(track.poles[k]) - damping(track.poles[k - 1]));
    // Twice the diagram's tolerance: its letters also count the vectors.
    if (df <= options.frequency_tolerance &&
        change <=
            2.0 * options.damping_tolerance * damping(track.poles[k - 1])) {
      ++track.stable;
    }
  }
  track.share = static_cast<double>(track.poles.size()) /
                static_cast<double>(count - positions.front());
}

}  // namespace

Stabilisation stabilise(const std::vector<OrderPoles>& orders,
                        double low,
                        double high,
                        const IdentifyOptions& options) {
  Stabilisation result;
  const double margin = 0.05 * (high - low);
  std::vector<std::vector<int>> positions;
  std::vector<int> last_seen;
  OrderPoles before;
  const auto count = static_cast<int>(orders.size());
  for (int position = 0; position < count; ++position) {
    const OrderPoles now =
        admissible(orders[static_cast<std::size_t>(position)],
                   low - margin,
                   high + margin,
                   options.max_damping_ratio);
    std::vector<bool> used(static_cast<std::size_t>(now.poles.size()), false);
    for (const Link& link : possible_links(result.tracks,
                                           last_seen,
                                           position,
                                           now,
                                           options.frequency_tolerance)) {
      if (used[static_cast<std::size_t>(link.pole)]) continue;
      if (last_seen[link.track] == position) continue;
      extend_track(result.tracks[link.track], now, link);
      used[static_cast<std::size_t>(link.pole)] = true;
      last_seen[link.track] = position;
      positions[link.track].push_back(position);
    }
    for (Index p = 0; p < now.poles.size(); ++p) {
      const double omega = std::abs(now.poles(p));
      if (omega >= low && omega <= high) {
        result.diagram.push_back({now.order,
                                  omega / (2.0 * std::numbers::pi),
                                  damping(now.poles(p)),
                                  letter(now, p, before, options)});
      }
      if (used[static_cast<std::size_t>(p)]) continue;
      start_track(result.tracks, now, p);
      last_seen.push_back(position);
      positions.push_back({position});
    }
    before = now;
  }
  for (std::size_t t = 0; t < result.tracks.size(); ++t) {
    summarise(result.tracks[t], positions[t], count, options);
  }
  std::ranges::sort(result.tracks, {}, [](const Track& track) {
    return std::abs(track.pole);
  });
  return result;
}

}  // namespace tapfit::modal
