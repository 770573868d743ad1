// The room modal/mode_set. Modes as everything further on takes them: ModeSet;
// how sets of modes are compared, paired, written and made FRFs again.
// Out: ModeSet, MAC, pairs, synthesised FRFs, UFF 55.
// May include: its row in CONTRIBUTING.md.
//
// Identified modes: poles, shapes, and how far to trust them.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "modal/mode_set/pole_shifts.hpp"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::modal {

/// The poles of the stabilisation diagram that belong to one mode.
struct PoleCluster {
  int poles = 0;  ///< one per order at most; 0: found in the residual alone
  double frequency_hz = 0.0;  ///< mean
  double frequency_scatter_hz = 0.0;
  double damping_ratio = 0.0;  ///< mean
  double damping_scatter = 0.0;
};

/// One identified mode; window damping already taken out.
struct Mode {
  std::complex<double> pole;  ///< [rad/s], Re < 0
  double frequency_hz = 0.0;  ///< |pole| / 2 pi
  double frequency_sd_hz = 0.0;
  double damping_ratio = 0.0;  ///< -Re(pole) / |pole|
  double damping_sd = 0.0;
  double mpc = 0.0;      ///< modal phase collinearity, 0..1
  double mpd_deg = 0.0;  ///< mean phase deviation, 0..90
  PoleCluster cluster;
  Eigen::VectorXcd shape;    ///< per ModeSet::dofs; unit modal mass if scaled
  Eigen::VectorXd shape_sd;  ///< sqrt(E|d shape|^2); empty where not known
};

/// Gives a mode its frequency [Hz] and damping ratio, and with them its pole.
void set_pole(Mode& mode, double frequency_hz, double damping_ratio);

/// The poles of one set-up, whose sensors load the structure their own way.
struct SetUpPoles {
  std::size_t set_up = 0;  ///< number by signal::set_ups
  Eigen::VectorXcd poles;  ///< per mode; 0 where not found [rad/s]
  Eigen::VectorXd log_sd;  ///< sd of ln|pole|; 0 where not found
};

/// One pole of the stabilisation diagram.
struct DiagramPole {
  int order = 0;
  double frequency_hz = 0.0;
  double damping_ratio = 0.0;
  char letter = 'o';  ///< o new, f frequency, d + damping, v + vector, s all
};

struct ModeSet {
  std::vector<Dof> dofs;  ///< rows of every shape, sign +1
  std::vector<Mode> modes;
  std::vector<SetUpPoles> set_ups;  ///< none where each shares the modes' poles
  /// Poles left out as their damping cannot be told from none [rad/s].
  std::vector<std::complex<double>> unresolved;
  std::optional<PoleShifts> shifts;  ///< where sensors move between set-ups
  bool scaled = false;  ///< unit modal mass (a driving point was measured)
  std::vector<DiagramPole> diagram;
  /// Rms of synthesised minus measured, relative, both weighted as they are
  /// fitted (weighted_frfs.hpp): with the diagram's own poles of these modes,
  /// and after refinement, which adds poles beside the band.
  double unrefined_error = 0.0;
  double synthesis_error = 0.0;
  /// The fitted model per FRF of the set given, on its lines, residual terms
  /// included [(m/s^2)/N]; empty when no mode was found.
  std::vector<Eigen::VectorXcd> fitted;
  std::vector<std::string> warnings;
};

}  // namespace tapfit::modal
