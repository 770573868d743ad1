// FRFs made ready for fitting: one matrix, every sign +1, a weight per value.
//
//   w_f(k) = 1 / sqrt(var_f(k) + (c h_f(k))^2)
//
// with var the FRF's variance averaged over a few lines, h the running rms of
// |H_f| and c a small floor: a model never fits a measurement to its noise, and
// ready FRFs or single hits may come without a variance.
#pragma once

#include "modal/poles/fit_sums.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::modal {

struct WeightedFrfs {
  Eigen::VectorXcd s;    ///< lines [rad/s], without s = 0
  double sigma = 0.0;    ///< Re(s), the same on all lines [rad/s]
  double spacing = 0.0;  ///< between lines [rad/s]
  Eigen::MatrixXcd H;    ///< n_lines x n_frfs accelerance, signs turned to +
  /// E|dH|^2, n_lines x n_frfs; at least the roughness of H over the lines for
  /// a single hit, which has no scatter to tell of.
  Eigen::MatrixXd variance;
  Eigen::MatrixXd weight;      ///< w, n_lines x n_frfs
  Eigen::VectorXd power;       ///< sum |H|^2 of each FRF
  SeparableWeights weights;    ///< nearest to w
  FitSums sums;                ///< of H with those weights
  std::vector<Dof> response;   ///< per FRF, sign +1
  std::vector<Dof> reference;  ///< per FRF, sign +1
  std::vector<std::size_t> run;
  std::vector<std::size_t> set_up;  ///< signal::set_ups of the set given
  std::vector<std::size_t> source;  ///< index of the FRF in the set given

  [[nodiscard]] Eigen::Index lines() const { return s.size(); }
  [[nodiscard]] Eigen::Index count() const { return H.cols(); }
};

/// Checks and prepares a set. FRFs that are zero, or constant
/// beside others that are not, are left out.
///
/// @param warnings what was left out is said here
/// @throws InputError for fewer than 8 lines, lines that are not evenly spaced
///   or not of one sigma, values that are not finite or beyond 1e-60 and 1e60,
///   no FRF left
[[nodiscard]] WeightedFrfs prepare_frfs(const signal::FrfSet& frfs,
                                        std::vector<std::string>& warnings);

/// The FRFs given by index only.
[[nodiscard]] WeightedFrfs select_frfs(
    const WeightedFrfs& curves, const std::vector<Eigen::Index>& indices);

}  // namespace tapfit::modal
