#include "acquisition/simulator/virtual_test.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/samples/anti_alias.hpp"
#include "acquisition/samples/sinc_interpolation.hpp"

#include <cmath>
#include <optional>

namespace tapfit::acquisition {
namespace {

// Modes above this part of the fast rate are static: far above what the
// recorder's filter lets through, far below the images of the force.
constexpr double static_fraction = 1.0 / 8.0;

// Mean of the piecewise linear force over a hat, see the header.
Eigen::VectorXd acting_force(const Eigen::VectorXd& force) {
  const Eigen::Index n = force.size();
  Eigen::VectorXd mean = force * (10.0 / 12.0);
  mean.head(n - 1) += force.tail(n - 1) / 12.0;
  mean.tail(n - 1) += force.head(n - 1) / 12.0;
  return mean;
}

Eigen::VectorXd delayed(const Eigen::VectorXd& signal, double samples) {
  Eigen::VectorXd late(signal.size());
  for (Eigen::Index n = 0; n < signal.size(); ++n) {
    late(n) = interpolate(signal, static_cast<double>(n) - samples);
  }
  return late;
}

}  // namespace

Eigen::MatrixXd simulate_response(const SecondOrderSystem& system,
                                  const std::vector<HammerPulse>& pulses,
                                  double seconds,
                                  const VirtualRecorder& recorder,
                                  const std::vector<double>& delay_s) {
  const double fast_hz = recorder.rate_hz * recorder.oversampling;
  const auto samples =
      static_cast<Eigen::Index>(std::llround(seconds * recorder.rate_hz)) *
      recorder.oversampling;
  const Eigen::VectorXd force = force_of(pulses, samples, fast_hz);
  const std::optional<ExactResponse> response =
      exact_response(system, force, fast_hz, static_fraction * fast_hz);
  if (!response) {
    throw InputError("the structure has no full set of complex modes",
                     "virtual test",
                     "give every rigid-body mode a support or every mode less "
                     "than critical damping");
  }
  const Eigen::VectorXd acting = acting_force(force);
  Eigen::MatrixXd fast(samples, 1 + response->acceleration.cols());
  fast.col(0) = acting;
  // The part of the acceleration that follows the force at once has no spring
  // to smooth the corners of a force in straight lines: take its mean too.
  fast.rightCols(response->acceleration.cols()) =
      response->acceleration + (acting - force) * response->direct.transpose();
  for (std::size_t c = 0; c < delay_s.size(); ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    if (delay_s[c] == 0.0) continue;
    fast.col(column) = delayed(fast.col(column), delay_s[c] * fast_hz);
  }
  return decimate(fast, recorder.oversampling);
}

Eigen::MatrixXd digitise(const Eigen::MatrixXd& response,
                         const VirtualRecorder& recorder,
                         const std::vector<AnalogueChannel>& channels,
                         SeededRandom& random) {
  Eigen::MatrixXd samples(response.rows(), response.cols());
  for (Eigen::Index c = 0; c < response.cols(); ++c) {
    samples.col(c) = pass_chain(response.col(c),
                                recorder.rate_hz,
                                channels.at(static_cast<std::size_t>(c)),
                                random);
  }
  return samples;
}

double choose_sensitivity(double largest,
                          double full_scale_volts,
                          double headroom) {
  const double wanted = full_scale_volts / (headroom * largest);
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= wanted) return step * decade;
  }
  return decade;
}

}  // namespace tapfit::acquisition
