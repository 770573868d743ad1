// The room signal/estimate. From spectra to FRFs: H1, H2, Hv, coherence,
// variance; whether they change with the force or from run to run. The replay
// does the same hit by hit.
// In:  A test bundle, its recordings and hits.
// Out: FrfSet with statements on what is odd.
// May include: its row in CONTRIBUTING.md.
//
// FRFs of every placement from the accepted hits of its runs.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "signal/estimate/estimator.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "signal/spectra/hit_blocks.hpp"

namespace tapfit::signal {

struct WindowOptions {
  bool force_window = true;  ///< rectangle with cosine taper around the pulse
  /// Value of the exponential window at the block's end; 1 = none. The error of
  /// the block's end is end_value times the share of the response that is left
  /// there: with 0.01 it is 1 % for a response that has not decayed at all, and
  /// nothing that counts for one that has (sigma T = 4.6).
  double end_value = 0.01;
};

struct FrfOptions {
  Estimator estimator = Estimator::H1;
  WindowOptions window;
  /// Poles of modes that outlast a block [rad/s]; may be empty. Their ringing
  /// from earlier hits is taken off (signal/spectra/carry_over.hpp), their
  /// decay behind the block's end is added (signal/spectra/block_tail.hpp).
  Eigen::VectorXcd lasting_poles;
};

/// FRFs on the FFT lines of the block that lie inside the band.
///
/// Force and response carry the same exponential window, so that the result is
/// the transfer function on s = sigma + j omega, sigma = -ln(end_value) / T.
///
/// Hits of runs that measured the same (acquisition/bundle/runs_alike.hpp) are
/// averaged together: one FRF per such group and sensor, its `run` the first of
/// them, signs of the degrees of freedom as the bundle gives them. Runs without
/// an accepted hit are left out (and stated). Velocity and displacement are
/// made accelerances by s and s^2. Lines are those inside TestBundle::band_hz;
/// without it all but line 0. Where the response lasts longer than the block, a
/// longer one or a narrower band is proposed first among the statements.
///
/// @throws InputError when no hit is accepted or no line lies in the band
[[nodiscard]] FrfSet estimate_frfs(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const FrfOptions& options,
    const Progress& progress = {});

/// What estimate_frfs() says of blocks that are too short for the response
/// (signal/decay/block_advice.hpp), without estimating; nothing where they are
/// not.
[[nodiscard]] std::vector<std::string> block_statements(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const FrfOptions& options);

/// What estimate_frfs() does with each run's blocks.
struct FrfPlan {
  Eigen::VectorXcd s;      ///< lines [rad/s]
  BlockOptions blocks;     ///< how they are cut and windowed
  double sigma = 0.0;      ///< of the exponential window [1/s]
  Eigen::Index first = 0;  ///< FFT lines first ... last
  Eigen::Index last = 0;
};

/// The plan for blocks as `hits` has them.
/// @throws InputError when no line lies in the band, or blocks hold no response
[[nodiscard]] FrfPlan plan_frfs(const acquisition::TestBundle& bundle,
                                const acquisition::HitSet& hits,
                                const FrfOptions& options);

/// FRFs at given points of the s-plane (each line its own exponential window),
/// for comparing with a model on a damped line.
///
/// H1 with the force window. The block's end cuts off exp(-Re(s) T) of what is
/// left of the response, but for the modes whose poles are given: Re(s) T of 5
/// or more makes that less than 1 %.
///
/// @param s complex angular frequencies [rad/s], Re(s) >= 0
/// @param lasting_poles as in FrfOptions
/// @throws InputError when no hit is accepted or a line lies at Re(s) < 0
[[nodiscard]] FrfSet estimate_frfs_at(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const Eigen::VectorXcd& s,
    const Eigen::VectorXcd& lasting_poles,
    const Progress& progress = {});

}  // namespace tapfit::signal
