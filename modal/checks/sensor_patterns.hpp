// What the sensors of each run show of the modes beside each other, which is
// the same from run to run, whatever point is hit: which runs differ, and
// whether by one factor on one sensor.
#pragma once

#include "modal/checks/sensor_law.hpp"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <vector>

namespace tapfit::modal {

struct RunResidueLimits {
  std::size_t fewest_runs = 4;
  /// Relative error of a run's pattern over the sensors: that much, and so many
  /// times the lower quartile of all runs.
  double much = 0.03;
  double times_usual = 6.0;
  /// And so many times the noise that is stated of it.
  double times_noise = 3.0;
  /// One factor explains the difference where it leaves this share of it, a law
  /// where it leaves this share of what the factor leaves.
  double one_factor = 0.2;
  /// And where the modes, each by itself, ask for the same one: root mean
  /// square in standard deviations, `much` of the factor among them.
  double scatter = 3.0;
  /// Modes that tell an integral or derivative from another point.
  int fewest_modes_of_law = 3;
};

/// Modal constants of runs whose sensors sit at the same points.
struct SensorSetUp {
  std::vector<std::size_t> channels;  ///< of the sensors, ascending
  std::vector<std::size_t> runs;
  Eigen::VectorXcd poles;           ///< of the modes
  std::vector<Eigen::MatrixXcd> z;  ///< per run: sensors x modes
  std::vector<Eigen::MatrixXd> sd;
};

/// How a run's sensors differ from the common pattern.
struct SensorPattern {
  double error = 0.0;      ///< relative, after the amplitude of each mode
  double noise = 0.0;      ///< that is stated of it, which is not in it
  std::size_t sensor = 0;  ///< one factor on it explains the most
  std::complex<double> factor = 1.0;  ///< that factor
  SensorLaw law = {};                 ///< over frequency, where it has one
  double left = 0.0;                  ///< error with it
  int modes = 0;                      ///< that tell the factor
  double scatter = 0.0;  ///< of their factors, in standard deviations, rms
};

/// The largest error that is usual: up to a half of the runs may be changed, so
/// that the lower quartile is of those that are not.
/// @param errors of the runs, one or more
[[nodiscard]] double usual_limit(Eigen::VectorXd errors,
                                 const RunResidueLimits& limits);

/// Each run against the pattern over the sensors that most runs show.
/// @param set_up one run or more, modes one or more
/// @return one for each run
[[nodiscard]] std::vector<SensorPattern> compare_patterns(
    const SensorSetUp& set_up, const RunResidueLimits& limits);

}  // namespace tapfit::modal
