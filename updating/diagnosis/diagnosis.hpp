// What may be missing from the model, ranked, and how sure one can be.
#pragma once

#include "acquisition/foundation/dof.hpp"

#include <Eigen/Core>

#include <complex>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Where an effect sits; which member is used depends on the effect.
struct Where {
  int node = 0;  ///< 0: not used
  std::vector<int> nodes = {};
  std::vector<int> elements = {};
  std::vector<std::string> channels = {};
  /// Which form of the effect, where it has several: "rotation",
  /// "translation"; "each" for one mass per channel instead of a shared one;
  /// "rotary" for a mass with an inertia.
  std::string variant = {};

  bool operator==(const Where&) const = default;
};

/// "node 201", "acc1, acc2", "19 nodes (1 ... 38)".
[[nodiscard]] std::string describe(const Where& where);

struct Estimate {
  std::string name;  ///< for example "mass_kg"; ends in its unit
  double value = 0.0;
  double sd = 0.0;
  double lo95 = 0.0;
  double hi95 = 0.0;
  std::string unit = {};  ///< where the name does not end in it
  bool at_bound = false;  ///< the fit would go on: the interval is one-sided
};

struct EffectRef {
  std::string effect;
  Where where;

  bool operator==(const EffectRef&) const = default;
};

/// An effect that was added to the model; one that is off stays in the list.
struct AddedEffect {
  EffectRef ref;
  bool on = true;
  bool together = false;  ///< in one step with the one before it

  bool operator==(const AddedEffect&) const = default;
};

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

/// A point that was elsewhere than it was written down.
struct Misplaced {
  std::string channel;  ///< the sensor's; empty: hit points
  Dof written;
  Dof likely;                ///< where its FRFs fit
  double error = 0.0;        ///< of its FRFs where it was written down
  double error_there = 0.0;  ///< and where it is likely to have been
};

struct Candidate {
  std::string effect;  ///< catalogue name, for example "added-mass"
  Where where;
  std::vector<Estimate> parameters;
  double probability = 0.0;
  double error = 0.0;           ///< after adding it, all refitted
  double held_out_error = 0.0;  ///< on runs it was not fitted to
  std::vector<EffectRef> indistinguishable_from;
};

/// A mass on a spring and a dashpot; see absorber_stiffness().
struct AbsorberLaw {
  double mass_kg = 0.0;
  double frequency_hz = 0.0;
  double damping_ratio = 0.0;
  double unexplained = 1.0;  ///< share of z that it leaves
};

/// The missing dynamic stiffness z(s) at one place against frequency.
struct Signature {
  int node = 0;
  Eigen::VectorXd frequency_hz;
  Eigen::VectorXcd z;      ///< [N/m]
  Eigen::VectorXd z_sd;    ///< [N/m]
  double explained = 0.0;  ///< share of the discrepancy one place explains
  /// Share of z left unexplained by each law: mass, spring, dashpot.
  double mass_unexplained = 1.0, mass_kg = 0.0;
  double spring_unexplained = 1.0, spring_n_per_m = 0.0;
  double dashpot_unexplained = 1.0, dashpot_ns_per_m = 0.0;
  /// Has three parameters, and so always leaves less than a mass alone.
  AbsorberLaw absorber = {};
};

/// Of a candidate that no linear model holds: it cannot be added.
inline constexpr const char* nonlinearity = "nonlinearity";

/// What an effect must lower the error to, as a share of what it was. Mesh and
/// model form leave errors of a few percent that some effect can always shave a
/// little.
inline constexpr double worth_it = 0.85;

/// Names of the rungs that are no effects.
inline constexpr const char* base_rung = "base";
inline constexpr const char* uncertain_rung = "uncertain properties";

struct Rung {
  std::string added;  ///< effect, or one of the names above
  Where where;
  double error = 0.0;
  std::vector<Estimate> parameters;
  double probability = 1.0;  ///< among all tried with the same other effects
  std::vector<EffectRef> alike = {};  ///< what explains the data as well
  int stopped_after = 0;  ///< steps, where its fit was ended by hand, else 0
};

/// The most probable kind of a rung that may name a group: "a" of "a|b".
[[nodiscard]] std::string leading_kind(const Rung& rung);

struct Diagnosis {
  std::string verdict;  ///< "none", "unexplained", "added-mass", "a+b", "a|b"
  double error_base = 0.0;
  /// With what is uncertain in the model fitted and no effect added; what an
  /// effect is worth counts from here.
  double error_fitted = 0.0;
  double error_best = 0.0;
  double floor = 0.0;
  std::string contour;
  std::vector<Candidate> candidates;       ///< most probable first
  std::vector<Rung> ladder;                ///< without the base
  std::vector<Estimate> model_parameters;  ///< "E:1" and so on
  /// One for each rung that something else explains as well.
  std::vector<NextMeasurement> next;
  std::vector<Misplaced> misplaced;  ///< their FRFs are left out
  std::vector<std::string> warnings;
};

/// Whether that measurement would show which of the two it is: they differ by
/// more than the floor there, and by twice what they do so far.
[[nodiscard]] bool is_telling(const NextMeasurement& next, double floor);

/// "hit 12Z+, move acc2 to 40Z+: predictions differ by 8 % (0.4 % so far)", or
/// that no point tells the two apart.
[[nodiscard]] std::string advice(const NextMeasurement& next, double floor);

}  // namespace tapfit::updating
