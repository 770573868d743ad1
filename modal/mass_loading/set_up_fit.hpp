// Each set-up, the runs with the sensors at the same points, identified by
// itself.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/poles/identify_options.hpp"
#include "modal/poles/stabilisation.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

/// One set-up's modes.
struct SetUpFit {
  std::size_t set_up = 0;
  std::vector<Eigen::Index> frfs;
  WeightedFrfs curves;  ///< those FRFs
  std::vector<Track> tracks;
  ModalFit fit;
  Eigen::MatrixXd residue_variance;  ///< E|dR|^2; see estimate_uncertainty()
  Eigen::MatrixXd pole_covariance;   ///< as of pole_covariance()
};

/// All set-ups in their order, several at a time. Their uncertainty is not
/// estimated yet.
[[nodiscard]] std::vector<SetUpFit> fit_set_ups(const WeightedFrfs& curves,
                                                const IdentifyOptions& options,
                                                const Progress& progress);

/// Fills in what the noise on all lines makes of poles and residues.
void estimate_uncertainty(SetUpFit& fit);

}  // namespace tapfit::modal
