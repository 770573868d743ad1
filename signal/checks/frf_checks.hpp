// The room signal/checks. What a measurement is held against without any model:
// driving points, reciprocity, coherence of hits, a free mass.
// In:  FRFs, and hits where these count.
// Out: Findings as numbers and in words. Nothing is changed.
// May include: its row in CONTRIBUTING.md.
//
// What an FRF set can be held against without any model: passive structures
// take up energy where they are hit, and answer alike both ways.
//
//   driving point:  Re M(s) >= 0 for Re(s) >= 0, M = A / s the mobility
//                   (a positive real function); Im A > 0 at every peak
//   reciprocity:    A_ab = A_ba; A_ab = A_ba + c where the force's signal
//                   leaks into the sensor's
//   lowest lines:   signal/checks/low_line.hpp
//   H1, H2:         H2 / H1 = 1 / coherence
//
// Sources: O. Brune, "Synthesis of a finite two-terminal network whose
// driving-point impedance is a prescribed function of frequency", J. Math.
// Phys. 10, 1931 (positive real functions); D. J. Ewins, "Modal testing", 2nd
// ed. 2000, ch. 3; ISO 7626-1.
#pragma once

#include "signal/checks/low_line.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace tapfit::signal {

/// Which label of a driving point is another's.
enum class WrongLabel { Either, Channel, Blow };

struct DrivingPoint {
  std::size_t frf = 0;  ///< index into the set
  int peaks = 0;        ///< of |A|, where Im A stands out of its noise
  int wrong_peaks = 0;  ///< with Im A below zero
  /// Share of lines with Re M below zero by more than three standard
  /// deviations of it (as stated or, if more, as the lines are rough).
  double active_share = 0.0;
  LowLine low = LowLine::Neither;
  double mass_kg = 0.0;            ///< with LowLine::Mass
  double stiffness_n_per_m = 0.0;  ///< with LowLine::Stiffness
  /// FRF of the same blows, elsewhere in the set, that would pass as this
  /// driving point where this one does not: two channels may be swapped.
  std::optional<std::size_t> rather;
  /// With `rather`: Blow where the run's sensors agree with those of other
  /// runs, Channel where they do not, Either where that is not known.
  WrongLabel wrong = WrongLabel::Either;

  /// Most peaks point the wrong way: the polarity of hammer or sensor is turned
  /// (or its point is another one).
  [[nodiscard]] bool turned() const { return 2 * wrong_peaks > peaks; }
  /// Gives energy away at more than one line in twenty.
  [[nodiscard]] bool active() const { return active_share > 0.05; }
  [[nodiscard]] bool fair() const { return wrong_peaks == 0 && !active(); }
  /// Some peaks point up and some down, as between two points.
  [[nodiscard]] bool mixed() const {
    return wrong_peaks > 0 && wrong_peaks < peaks;
  }
};

struct Reciprocal {
  std::size_t frf = 0;    ///< A_ab, index into the set
  std::size_t other = 0;  ///< A_ba
  /// Root of sum |A_ab - A_ba|^2 over the geometric mean of their norms.
  double difference = 0.0;
  /// Least-squares factor of A_ba that fits A_ab best; 1 for a fair pair.
  double gain = 1.0;
  /// What |A_ab - gain A_ba| leaves, relative to A_ab.
  double shape_difference = 0.0;
  /// Mean of |A_ab - A_ba|^2 over their variances; about 1 for what scatter
  /// alone explains. 0 where variances are not known.
  double chi2 = 0.0;
  /// Least-squares real constant of A_ab - A_ba, and what it leaves of that. No
  /// structure has one that is not reciprocal: force that leaks into a channel.
  double constant = 0.0;
  double beside_constant = 1.0;

  /// Scatter explains the difference, or it is too little to matter.
  [[nodiscard]] bool fair() const {
    return (chi2 > 0.0 && chi2 < 4.0) || difference < 0.02;
  }
  /// A factor explains all but a tenth of the difference (of the FRF itself,
  /// where they differ by more than that), or all but 2 %.
  [[nodiscard]] bool by_a_factor() const {
    return shape_difference < 0.1 * std::min(difference, 1.0) ||
           shape_difference < 0.02;
  }
  /// A constant explains nine tenths of the difference's power, a factor less.
  [[nodiscard]] bool by_a_constant() const {
    return beside_constant < 0.316 && !by_a_factor();
  }
};

/// That FRF taken for one of a driving point.
/// @param sign 1, or -1 where hammer and sensor point against each other
[[nodiscard]] DrivingPoint driving_point(const FrfSet& set,
                                         std::size_t index,
                                         double sign);

/// Two FRFs taken for the same path both ways.
/// @param sign of the first against the second
[[nodiscard]] Reciprocal compared(const FrfSet& set,
                                  std::size_t i,
                                  std::size_t j,
                                  double sign);

/// FRFs whose response is where the hammer hits, in its direction.
[[nodiscard]] std::vector<DrivingPoint> driving_points(const FrfSet& set);

/// Pairs measured both ways, each once.
[[nodiscard]] std::vector<Reciprocal> reciprocals(const FrfSet& set);

struct FrfChecks {
  std::vector<DrivingPoint> driving;
  std::vector<Reciprocal> both_ways;
};

[[nodiscard]] FrfChecks check_frfs(const FrfSet& frfs);

/// Largest H2 / H1 - 1 at the peaks of |H|; empty for a single hit.
[[nodiscard]] std::optional<double> spread_at_peaks(const Frf& frf);

}  // namespace tapfit::signal
