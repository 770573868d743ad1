// What a known change will do to a structure, before it is made.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/effects/effect_instance.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// A mode of the model now, and what becomes of it.
struct PredictedMode {
  int model = 0;                  ///< index among the model's modes now
  std::optional<int> measured{};  ///< index into ModeSet::modes, where paired
  double measured_hz = 0.0;       ///< now
  double measured_sd_hz = 0.0;
  double model_hz = 0.0;        ///< now
  double model_after_hz = 0.0;  ///< the model alone, after the change
  /// After the change: the model's, corrected by what was measured now; see
  /// predicted_modes.hpp.
  Estimate frequency_hz = {};
  Estimate change_hz = {};  ///< of the model: after less now
  Estimate change_percent = {};
  std::optional<double> damping_now{};
  std::optional<Estimate> damping_ratio{};  ///< after; none: not known
  double mac = 1.0;        ///< of its shapes before and after, in mass
  double misfit_sd = 0.0;  ///< measured less model now, in deviations of both
  Eigen::VectorXd phi{};   ///< its shape after, in the coordinates of the base
};

/// What becomes of an FRF on the line that models are compared on, in units of
/// the line's mean level, as relative errors are: root mean squares.
struct FrfChange {
  double change = 0.0;  ///< after less now
  double sd = 0.0;      ///< standard deviation of what is predicted
};

struct Prediction {
  std::vector<EffectInstance> with;    ///< effects that the model has now
  std::vector<EffectInstance> change;  ///< that are stated
  /// What the deck's form is off by, of a mode's frequency, relative.
  double form_sd = 0.0;
  std::vector<PredictedMode> modes;  ///< by the frequency that they have now
  signal::FrfSet frfs;               ///< after; of a test of modes none
  std::vector<FrfChange> frf_changes;
  std::vector<std::string> warnings;
  std::shared_ptr<const FrfModel> model;  ///< after
};

}  // namespace tapfit::updating
