// Whether FRFs change with the force of the hits: a structure with play, with
// friction or with large motions does, and no linear model explains it.
//
// The response that the FRF does not explain, e_k = X_k - H F_k, has no
// reason to follow the level a_k of the hit. Where H is H0 + (a - mean a) G,
//
//   e_k = (a_k - mean a) G F_k
//
// and least squares over the hits gives G and the share of |e|^2 that it
// explains on each line. The same with the levels of each run's hits in another
// order tells what share chance gives (permutation test; P. Good, "Permutation,
// Parametric and Bootstrap Tests of Hypotheses", 2005). It ends early when
// enough orders gave as large a share (J. Besag, P. Clifford, "Sequential Monte
// Carlo p-values", Biometrika 78(2), 1991).
#pragma once

#include "signal/frf_set/linearity_finding.hpp"
#include "signal/spectra/spectra.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace tapfit::signal {

/// Collects runs; each is a structure of its own (sensors may have moved).
class LinearityCheck {
 public:
  /// @return change of each sensor's FRF from the run's weakest hit to its
  /// strongest, lines x sensors; no columns where the levels do not tell
  Eigen::MatrixXcd add(const Spectra& spectra);
  /// Adds the runs of another.
  void add(LinearityCheck&& other);

  /// @param seed of the permutations
  [[nodiscard]] LinearityFinding finding(std::uint64_t seed) const;

 private:
  /// One run in terms of which any order of its levels is quickly tried.
  struct Run {
    Eigen::VectorXd level;            ///< per hit [as the force, rms]
    Eigen::MatrixXd power;            ///< lines x hits, |F|^2
    std::vector<Eigen::MatrixXcd> q;  ///< per sensor, conj(F) e, lines x hits
    std::vector<Eigen::VectorXd> unexplained;  ///< per sensor and line, |e|^2
    Eigen::VectorXd size;  ///< per line, sum of |H|^2 over sensors
  };
  static Eigen::MatrixXcd changes(const Run& run);
  static Eigen::VectorXd explained(const Run& run,
                                   std::size_t sensor,
                                   const Eigen::VectorXd& level,
                                   const Eigen::VectorXd& spread);
  static double shares(const Run& run, const Eigen::VectorXd& level);
  static Eigen::VectorXd change_squared(const Run& run);

  std::vector<Run> runs_;
};

}  // namespace tapfit::signal
