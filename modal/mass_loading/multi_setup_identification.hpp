// The room modal/mass_loading. Modes that move because the sensors do:
// identified set-up by set-up, and what their shifts say of the sensors' mass.
// In:  Weighted FRFs of several set-ups.
// Out: One set of modes with each set-up's own poles, and the cause of the
//      shifts.
// May include: its row in CONTRIBUTING.md.
//
// Modes when the sensors move between set-ups and their mass moves the modes.
//
// Then no pole is common to all runs. Each set-up (runs with the sensors at the
// same points) is identified by itself; modes of different set-ups that are
// close in frequency are one mode, each set-up having it at most once. Its
// frequency is the mean, its standard deviation the scatter, and each FRF's
// residue comes from its own set-up.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "modal/poles/identify_options.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace tapfit::modal {

/// The set-ups' fits, and which modes of them are one.
struct SetUpFits;

struct MultiSetupModes {
  Eigen::VectorXcd poles;    ///< mean over set-ups [rad/s]
  Eigen::VectorXcd scatter;  ///< sd over set-ups: of Re + j of Im [rad/s]
  Eigen::VectorXd frequency_range;   ///< (largest - smallest) / mean
  Eigen::MatrixXcd residues;         ///< n_frfs x n_modes; 0 where not found
  Eigen::MatrixXd residue_variance;  ///< E|dR|^2, n_frfs x n_modes
  Eigen::MatrixXcd H;                ///< fitted, n_lines x n_frfs
  Eigen::MatrixXcd unrefined_H;      ///< by the diagrams' own poles
  Eigen::VectorXd frf_weight;        ///< as in ModalFit, n_frfs
  std::vector<SetUpPoles> set_ups;   ///< in order, of n_modes each
  std::shared_ptr<const SetUpFits> made_of;
};

/// True when no sensor point is measured in more than half of the set-ups,
/// of which there are several.
[[nodiscard]] bool sensors_rove(const WeightedFrfs& curves);

/// Identifies every set-up by itself and joins the modes.
///
/// @return empty when there is one set-up only, when one shows no mode or no
/// mode is in two of them
[[nodiscard]] std::optional<MultiSetupModes> identify_per_set_up(
    const WeightedFrfs& curves,
    const IdentifyOptions& options,
    const Progress& progress);

/// Carries out edits in their order: takes the mode with the nearest mean
/// frequency out of every set-up that has it, or puts a pole in near a
/// frequency in every set-up where one can be fitted.
///
/// @throws InputError of mode_to_drop(); of add_pole() in the first set-up
///   where no set-up takes the pole
[[nodiscard]] MultiSetupModes edited(const WeightedFrfs& curves,
                                     const std::vector<PoleEdit>& edits,
                                     const MultiSetupModes& modes);

}  // namespace tapfit::modal
