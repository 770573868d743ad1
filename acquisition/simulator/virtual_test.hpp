// The room acquisition/simulator. A hammer test without a laboratory: hand,
// structure, sensors, recorder.
// In:  Matrices of a small structure and what the recorder is like.
// Out: Samples as a recorder delivers them. Used by virtual tests and by tests
//      of the program, not by the way from recording to result.
// May include: its row in CONTRIBUTING.md.
//
// A hammer test without a laboratory: hits, exact response, the recorder.
//
// Force and response are made at a multiple of the sampling rate. The force is
// linear between fast samples; its mean over a hat of two fast steps,
// (f[n-1] + 10 f[n] + f[n+1]) / 12, has the spectrum of the continuous force up
// to order (w h)^4, so that the recorded force is the force that acted.
// Knows nothing of finite elements: the structure comes as a small system.
#pragma once

#include "acquisition/simulator/analogue_chain.hpp"
#include "acquisition/simulator/exact_response.hpp"
#include "acquisition/simulator/hammer_pulse.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace tapfit::acquisition {

struct VirtualRecorder {
  double rate_hz = 256.0;
  int oversampling = 16;
};

/// What the sensors feel and the hammer exerts in one run, filtered and at the
/// recorder's rate, still without noise or overload.
///
/// @param seconds length of the recording
/// @param delay_s per channel (hammer first); empty: none
/// @return n_samples x (1 + sensors), hammer first [N, m/s^2]
/// @throws InputError when the structure has no full set of complex modes
[[nodiscard]] Eigen::MatrixXd simulate_response(
    const SecondOrderSystem& system,
    const std::vector<HammerPulse>& pulses,
    double seconds,
    const VirtualRecorder& recorder,
    const std::vector<double>& delay_s);

/// Passes every channel through its chain; samples in [-1, 1).
///
/// @param response n_samples x channels, as from simulate_response
/// @param random a stream of this run's own
[[nodiscard]] Eigen::MatrixXd digitise(
    const Eigen::MatrixXd& response,
    const VirtualRecorder& recorder,
    const std::vector<AnalogueChannel>& channels,
    SeededRandom& random);

/// Volts per unit, of the steps 1-2-5 that makers offer, at which full scale
/// lies at least `headroom` above the largest value expected.
[[nodiscard]] double choose_sensitivity(double largest,
                                        double full_scale_volts,
                                        double headroom);

}  // namespace tapfit::acquisition
