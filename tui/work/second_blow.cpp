#include "tui/work/second_blow.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using acquisition::HitFault;

double second_blow(const Trace& trace,
                   std::size_t hammer,
                   const acquisition::HitSet& hits,
                   const acquisition::Hit& hit) {
  if (std::ranges::find(hit.reasons, HitFault::Double) == hit.reasons.end()) {
    return hit.time_s;
  }
  const auto channel = static_cast<Eigen::Index>(hammer);
  if (trace.low.rows() == 0 || channel >= trace.low.cols()) return hit.time_s;
  const auto row_at = [&](Eigen::Index sample) {
    return std::clamp<Eigen::Index>(
        sample / trace.stretch, 0, trace.low.rows() - 1);
  };
  const double rate = trace.sample_rate_hz;
  const Eigen::Index reach =
      hits.hold_off > 0 ? std::min(hits.hold_off, hits.block) : hits.block;
  const Eigen::Index last = row_at(hit.trigger + reach);
  double largest = 0.0;
  double found_s = hit.time_s;
  for (Eigen::Index row = row_at(hit.begin); row <= last; ++row) {
    const double middle = static_cast<double>(row * trace.stretch) +
                          0.5 * static_cast<double>(trace.stretch - 1);
    const double time_s = middle / rate;
    if (std::abs(time_s - hit.time_s) < 1.5 * hit.pulse_s) continue;
    const double force = std::max(std::abs(trace.low(row, channel)),
                                  std::abs(trace.high(row, channel)));
    if (force <= largest) continue;
    largest = force;
    found_s = time_s;
  }
  return found_s;
}

}  // namespace tapfit::tui
