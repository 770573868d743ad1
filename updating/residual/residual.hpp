// The room updating/residual. Model against measurement on the lines in use.
// In:  FrfModel with a state, measured FRFs or modes.
// Out: residuals and their Jacobians, which lines they are taken on, and what
//      they say of parameters.
// May include: its row in CONTRIBUTING.md.
//
// The difference between measured and modelled FRFs, weighted so that
// resonances and valleys count alike.
//
//   r_lf = (H_model - H_measured)_lf / (sqrt(N) w_l),  w_l^2 = mean_f |H_lf|^2
//
// so that ||r|| is the relative FRF error (root mean square over all FRFs and
// lines).
//
// Of measured modes (modal_data.hpp) a line is a mode, its "FRFs" are its
// frequency and its shape's values, and ||r|| is the root mean square of all of
// them in units of sd, times sd: an error of frequencies. They are few and how
// they scatter is stated, so that what that says of the residual's variance
// counts as some data more, the last entry of the residual.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/frf_model/modal_data.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Of modes: as many readings as told how they scatter.
inline constexpr double known_scatter = 10.0;

/// Measured FRFs as a matrix, with the weight of every line.
struct Target {
  Eigen::VectorXcd s;
  Eigen::MatrixXcd H;            ///< lines x FRFs
  Eigen::MatrixXd variance;      ///< lines x FRFs
  Eigen::VectorXd weight;        ///< w_l
  std::vector<std::size_t> run;  ///< of each FRF
  std::vector<double> use;       ///< 1, or 0 for an FRF that is left out
  int modes_in_band = 0;         ///< as identified; 0: not known
  /// Of modes what all data scatter by, relative; 0: FRFs.
  double modal_sd = 0.0;
  /// What the deck's form and its mesh may add to stack(), a column for each
  /// deviation.
  Eigen::MatrixXd form_bias = {};

  [[nodiscard]] double count() const;
  [[nodiscard]] bool is_modal() const { return modal_sd > 0.0; }
};

[[nodiscard]] Target make_target(const signal::FrfSet& measured);
[[nodiscard]] Target make_target(const ModalData& measured);

/// Their FRFs are in use no more.
/// @param runs counted from 0
void leave_out(const std::vector<std::size_t>& runs, Target& target);

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

/// Real residual, 2 lines FRFs: real parts, then imaginary ones, FRF by FRF. Of
/// modes a zero behind.
[[nodiscard]] Eigen::VectorXd stack(const Target& target,
                                    const Eigen::MatrixXcd& difference);

/// The residual of a model's response: stack() of the difference, and of modes
/// behind it what is known of their scatter.
[[nodiscard]] Eigen::VectorXd residual(const Target& target,
                                       const Eigen::MatrixXcd& H);

/// The relative error that a residual is.
[[nodiscard]] double error_of(const Target& target,
                              const Eigen::VectorXd& residual);

}  // namespace tapfit::updating
