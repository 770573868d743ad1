#include "updating/fit/typical_damping.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tapfit::updating {

using Eigen::Index;

double typical_damping(const UpdateResult& result) {
  const ModelState& state = result.state;
  const auto first = static_cast<Index>(state.factor.size());
  const Eigen::MatrixXd& covariance = result.covariance;
  std::vector<std::pair<double, double>> seen;  // ratio, share
  double half = 0.0;
  for (Index q = 0; q < state.zeta.size(); ++q) {
    const Index k = first + q;
    if (k >= covariance.rows()) break;
    const double prior = result.prior.sd(k) * result.prior.sd(k);
    const double share = std::clamp(1.0 - covariance(k, k) / prior, 0.0, 1.0);
    seen.emplace_back(state.zeta(q), share);
    half += 0.5 * share;
  }
  constexpr double nothing = 1e-3;
  if (half < nothing) return state.zeta_other;
  std::ranges::sort(seen);
  double sum = 0.0;
  for (const auto& [zeta, share] : seen) {
    sum += share;
    if (sum >= half) return zeta;
  }
  return state.zeta_other;
}

}  // namespace tapfit::updating
