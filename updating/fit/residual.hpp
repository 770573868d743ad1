// The difference between measured and modelled FRFs, weighted so that
// resonances and valleys count alike.
//
//   r_lf = (H_model - H_measured)_lf / (sqrt(N) w_l),  w_l^2 = mean_f |H_lf|^2
//
// so that ||r|| is the relative FRF error (root mean square over all FRFs and
// lines).
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Measured FRFs as a matrix, with the weight of every line.
struct Target {
  Eigen::VectorXcd s;
  Eigen::MatrixXcd H;            ///< lines x FRFs
  Eigen::MatrixXd variance;      ///< lines x FRFs
  Eigen::VectorXd weight;        ///< w_l
  std::vector<std::size_t> run;  ///< of each FRF
  std::vector<double> use;       ///< 1, or 0 for an FRF that is left out
  /// What the mesh may be off by, as a residual of stack(); empty: not known.
  Eigen::VectorXd mesh_bias = {};
  /// What the deck's form may add to stack(), a column for each deviation.
  Eigen::MatrixXd form_bias = {};

  [[nodiscard]] double count() const;
};

[[nodiscard]] Target make_target(const signal::FrfSet& measured);

/// Root mean square error of the FRFs in use.
[[nodiscard]] double relative_error(const Target& target,
                                    const Eigen::MatrixXcd& H);
/// The same for one FRF or one range of lines.
[[nodiscard]] double frf_error(const Target& target,
                               const Eigen::MatrixXcd& H,
                               Eigen::Index frf);
[[nodiscard]] double block_error(const Target& target,
                                 const Eigen::MatrixXcd& H,
                                 Eigen::Index first_line,
                                 Eigen::Index lines,
                                 Eigen::Index first_frf,
                                 Eigen::Index frfs);
/// Error that the scatter over hits alone would give.
[[nodiscard]] double noise_error(const Target& target);

/// Real residual, 2 lines FRFs: real parts, then imaginary ones, FRF by FRF.
[[nodiscard]] Eigen::VectorXd stack(const Target& target,
                                    const Eigen::MatrixXcd& difference);

/// Independent real data in the target: lines on a damped line overlap.
[[nodiscard]] double effective_data(const Target& target);

/// Independent data in what a fit leaves. What mesh and model form leave is no
/// noise, but a few patterns over lines and FRFs that belong together: with
/// the singular values s_k of the residual (lines x FRFs),
/// P = (sum s^2)^2 / sum s^4 of them count, and the residual is worth 2 P^2
/// data, after the 1 / lines + 1 / FRFs that noise alone adds to 1 / P. At
/// most effective_data().
[[nodiscard]] double residual_data(const Target& target,
                                   const Eigen::VectorXd& residual);

}  // namespace tapfit::updating
