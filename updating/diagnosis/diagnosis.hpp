// What may be missing from the model, ranked, and how sure one can be.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "updating/diagnosis/model_form.hpp"
#include "updating/diagnosis/rivals.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/fit/rung.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// What would tell two explanations apart that fit the data alike.
struct NextMeasurement {
  EffectRef one;
  EffectRef other;
  Dof hit;
  Dof sensor;
  std::string channel;        ///< the sensor's
  bool moves_sensor = false;  ///< it does not stand there yet
  /// Between the two predictions of that FRF, in units of the relative error.
  double difference = 0.0;
  double difference_now = 0.0;  ///< the largest of any FRF measured so far
};

struct Candidate {
  std::string effect;  ///< catalogue name, for example "added-mass"
  Location where;
  std::vector<Estimate> parameters;
  double probability = 0.0;
  double error = 0.0;           ///< after adding it, all refitted
  double held_out_error = 0.0;  ///< on runs it was not fitted to
  std::vector<EffectRef> indistinguishable_from;
  std::vector<double> place_sd = {};  ///< see EffectRef; the parameters hold it
  std::vector<double> sizes = {};     ///< of the fit that the error is of
};

/// What the sheet or the deck says wrongly.
struct SetUpMistake {
  /// Catalogue name, for example "point-mislabelled"; or "run-outlier".
  std::string mistake;
  Location where;
  double probability = 0.0;
  double error = 0.0;  ///< relative FRF error with it put right
  std::string edit;    ///< what to correct, see sheet_edits() and CardSlip
};

/// What becomes of a verdict when something that was assumed is changed.
struct Robustness {
  std::string change;  ///< "prior of E:1 doubled"
  std::string verdict;
  bool verdict_stands = true;
  std::vector<Estimate> parameters;  ///< of the ladder, as "EFFECT NAME"
  /// How far the farthest of them moved, in standard deviations of the
  /// diagnosis; 0 where there are none.
  double largest_move_sd = 0.0;
};

struct Diagnosis {
  std::string verdict;  ///< "none", "unexplained", "added-mass", "a+b", "a|b"
  double error_base = 0.0;
  /// With what is uncertain in the model fitted and no effect added; what an
  /// effect is worth counts from here.
  double error_fitted = 0.0;
  double error_best = 0.0;
  double floor = 0.0;
  /// What the deck is wrong by in form, as far as it is estimated from what the
  /// best fit leaves: standard deviation of a mode's frequency, relative.
  double form_sd = 0.0;
  double form_error = 0.0;  ///< what it explains of error_best
  std::string contour;
  std::vector<Candidate> candidates;       ///< most probable first
  std::vector<Rung> ladder;                ///< without the base
  std::vector<Estimate> model_parameters;  ///< "E:1" and so on
  std::vector<ModelForm> model_form = {};  ///< no part of verdict or ladder
  /// One for each rung that something else explains as well.
  std::vector<NextMeasurement> next;
  /// Of the ladder, put right there, the deck's own numbers first; then runs
  /// that are left out.
  std::vector<SetUpMistake> set_up;
  std::vector<std::string> warnings;
  Rivals rivals = {};
  std::vector<Robustness> robustness = {};  ///< where it was asked for
};

/// Whether that measurement would show which of the two it is: they differ by
/// more than the floor there, and by twice what they do so far.
[[nodiscard]] bool is_significant(const NextMeasurement& next, double floor);

/// "hit 12Z+, move acc2 to 40Z+: predictions differ by 8 % (0.4 % so far)", or
/// that no point tells the two apart.
[[nodiscard]] std::string advice(const NextMeasurement& next, double floor);

}  // namespace tapfit::updating
