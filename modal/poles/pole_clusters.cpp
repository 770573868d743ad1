#include "modal/poles/pole_clusters.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

double deviation(const Eigen::ArrayXd& values) {
  if (values.size() < 2) return 0.0;
  return std::sqrt((values - values.mean()).square().sum() /
                   static_cast<double>(values.size() - 1));
}

}  // namespace

std::optional<std::size_t> nearest_track(const std::vector<Track>& tracks,
                                         const std::complex<double>& pole) {
  std::optional<std::size_t> best;
  double least = 0.01 * std::abs(pole);
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const double apart = std::abs(tracks[t].pole - pole);
    if (apart >= least) continue;
    least = apart;
    best = t;
  }
  return best;
}

PoleCluster cluster_of(const Track& track) {
  const auto all = static_cast<Eigen::Index>(track.poles.size());
  const Eigen::Index count = (all + 1) / 2;
  Eigen::ArrayXd frequency(count);
  Eigen::ArrayXd damping(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::complex<double>& pole =
        track.poles[static_cast<std::size_t>(all - count + k)];
    frequency(k) = std::abs(pole) / (2.0 * std::numbers::pi);
    damping(k) = -pole.real() / std::abs(pole);
  }
  PoleCluster cluster;
  cluster.poles = static_cast<int>(all);
  cluster.frequency_hz = frequency.mean();
  cluster.frequency_scatter_hz = deviation(frequency);
  cluster.damping_ratio = damping.mean();
  cluster.damping_scatter = deviation(damping);
  return cluster;
}

}  // namespace tapfit::modal
