#include "updating/minimiser/bounded_step.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Index> free_ones(const std::vector<bool>& held) {
  std::vector<Index> result;
  for (std::size_t k = 0; k < held.size(); ++k) {
    if (!held[k]) result.push_back(static_cast<Index>(k));
  }
  return result;
}

// Goes from d towards `to` as far as the bounds allow; what stops it is held.
// Returns whether it got there.
bool go(VectorXd& d,
        const VectorXd& to,
        const VectorXd& lower,
        const VectorXd& upper,
        std::vector<bool>& held) {
  double share = 1.0;
  Index stop = -1;
  for (Index k = 0; k < d.size(); ++k) {
    if (to(k) >= lower(k) && to(k) <= upper(k)) continue;
    const double bound = to(k) < lower(k) ? lower(k) : upper(k);
    const double here = (bound - d(k)) / (to(k) - d(k));
    if (here >= share && stop >= 0) continue;
    share = here;
    stop = k;
  }
  if (stop < 0) {
    d = to;
    return true;
  }
  d = (d + share * (to - d)).cwiseMax(lower).cwiseMin(upper);
  d(stop) = to(stop) < lower(stop) ? lower(stop) : upper(stop);
  held[static_cast<std::size_t>(stop)] = true;
  return false;
}

// The held one that gains most from leaving its bound, or -1.
Index released(const VectorXd& slope,
               const VectorXd& d,
               const VectorXd& lower,
               const VectorXd& upper,
               const MatrixXd& A,
               const std::vector<bool>& held) {
  Index best = -1;
  double most = 0.0;
  for (Index k = 0; k < d.size(); ++k) {
    if (!held[static_cast<std::size_t>(k)] || lower(k) == upper(k)) continue;
    const bool inward =
        d(k) <= lower(k) ? slope(k) < 0.0 : d(k) >= upper(k) && slope(k) > 0.0;
    const double gain = slope(k) * slope(k) / A(k, k);
    if (!inward || gain <= most) continue;
    most = gain;
    best = k;
  }
  return best;
}

}  // namespace

VectorXd bounded_step(const MatrixXd& A,
                      const VectorXd& g,
                      const VectorXd& lower,
                      const VectorXd& upper) {
  const Index n = g.size();
  VectorXd d = VectorXd::Zero(n);
  std::vector<bool> held(static_cast<std::size_t>(n), false);
  for (Index k = 0; k < n; ++k) {
    held[static_cast<std::size_t>(k)] =
        (lower(k) >= 0.0 && g(k) >= 0.0) || (upper(k) <= 0.0 && g(k) <= 0.0);
  }
  // Each turn lowers the quadratic; the count guards against rounding.
  for (Index turn = 0; turn < 20 * n + 20; ++turn) {
    const std::vector<Index> free = free_ones(held);
    const VectorXd slope = A * d + g;
    VectorXd to = d;
    to(free) -= A(free, free).eval().ldlt().solve(slope(free).eval());
    if (!go(d, to, lower, upper, held)) continue;
    const Index leaves = released(A * d + g, d, lower, upper, A, held);
    if (leaves < 0) break;
    held[static_cast<std::size_t>(leaves)] = false;
  }
  return d;
}

}  // namespace tapfit::updating
