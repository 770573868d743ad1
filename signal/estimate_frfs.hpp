// FRFs of every run from its accepted hits.
#pragma once

#include "acquisition/hits.hpp"
#include "acquisition/progress.hpp"
#include "signal/frf_set.hpp"

namespace tapfit::signal {

enum class Estimator { H1, H2, Hv };

struct WindowOptions {
  bool force_window = true;  ///< rectangle with cosine taper around the pulse
  /// Value of the exponential window at the block's end; 1 = none.
  double end_value = 0.05;
};

struct FrfOptions {
  Estimator estimator = Estimator::H1;
  WindowOptions window;
};

/// FRFs on the FFT lines of the block that lie inside the band.
///
/// Force and response carry the same exponential window, so that the result is
/// the transfer function on s = sigma + j omega, sigma = -ln(end_value) / T.
///
/// @param band_hz lower and upper frequency [Hz]; empty: all lines
[[nodiscard]] FrfSet estimate_frfs(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const FrfOptions& options,
    const Progress& progress = {});

/// FRFs at given points of the s-plane (each line its own exponential window),
/// for comparing with a model on a damped line.
///
/// @param s complex angular frequencies [rad/s], Re(s) >= 0
[[nodiscard]] FrfSet estimate_frfs_at(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const Eigen::VectorXcd& s,
    const Progress& progress = {});

}  // namespace tapfit::signal
