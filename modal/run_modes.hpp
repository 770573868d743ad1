// Modes when the sensors move between runs and their mass moves the modes.
//
// Then no pole is common to all runs. Each run is identified by itself; modes
// of different runs that are close in frequency are one mode, each run having
// it at most once. Its frequency is the mean, its standard deviation the
// scatter, and each FRF's residue comes from its own run.
#pragma once

#include "modal/identify_modes.hpp"
#include "modal/modal_fit.hpp"

#include <optional>
#include <vector>

namespace tapfit::modal {

struct RunModes {
  Eigen::VectorXcd poles;           ///< mean over runs [rad/s]
  Eigen::VectorXcd scatter;         ///< sd over runs: of Re + j of Im [rad/s]
  Eigen::VectorXd frequency_range;  ///< (largest - smallest) / mean
  Eigen::MatrixXcd residues;        ///< n_frfs x n_modes; 0 where not found
  Eigen::MatrixXcd H;               ///< fitted, n_lines x n_frfs
};

/// True when no sensor point is measured in more than half of the runs.
[[nodiscard]] bool sensors_rove(const Curves& curves);

/// Identifies every run by itself and joins the modes.
///
/// @return empty when a run shows no mode or no mode is in two runs or more
[[nodiscard]] std::optional<RunModes> identify_per_run(
    const Curves& curves,
    const IdentifyOptions& options,
    const Progress& progress);

}  // namespace tapfit::modal
