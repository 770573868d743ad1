// Whether modes that were measured after a change are those predicted. A mode
// deviates by
//
//   d = (f_measured - f) / (1.96 hypot(sd, sd_measured, r f))
//
// with r what frequencies scatter by from one set-up of the structure to the
// next, in units of the half width of its 95 % interval. Of n right intervals
// the worst exceeds 1 by chance in more than one of twenty: the limit is z
// / 1.96 with P(|Z| > z) = 0.05 / n, for which a right model is refuted once in
// twenty at the most, however its errors hang together (Bonferroni's bound).
// Source: R. G. Miller, "Simultaneous Statistical Inference", 2nd ed., 1981.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "updating/prediction/prediction.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct ConfirmedMode {
  int predicted = 0;  ///< index into Prediction::modes
  int measured = 0;   ///< index into the modes measured after
  double measured_hz = 0.0;
  double measured_sd_hz = 0.0;
  double deviation = 0.0;  ///< d, with its sign
  double mac = 0.0;        ///< at the points measured
  bool has_shape = true;   ///< else MAC says nothing
};

enum class Finding95 { Confirmed, Refuted, Undecided };

struct Confirmation {
  std::vector<ConfirmedMode> modes;
  std::vector<int> unseen;  ///< predicted modes that no measured one is like
  double limit = 1.0;       ///< of |d|
  Finding95 finding = Finding95::Undecided;
};

/// @param after modes measured after the change, at grids of the same deck:
///   points that it does not have are left out
/// @param repeatability r, relative
[[nodiscard]] Confirmation confirm(const Prediction& prediction,
                                   const modal::ModeSet& after,
                                   double repeatability = 0.0);

/// "refuted: the mode at 21.30 Hz, predicted at 20.10 Hz, is 2.1 half widths
/// of its interval off (limit 1.3 for 5 modes)".
[[nodiscard]] std::string statement(const Confirmation& confirmation,
                                    const Prediction& prediction);

}  // namespace tapfit::updating
