// Where the model fails: measured against model, in numbers that can each be
// traced to curves.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// The model's modes at the measured degrees of freedom and on the grids.
struct ModelModes {
  Eigen::VectorXd frequency_hz;
  Eigen::MatrixXd at_dofs;   ///< n_measured_dof x n_modes, as ModeSet::dofs
  Eigen::MatrixXd at_grids;  ///< 3 n_grids x n_modes: x, y, z of each deck grid
};

/// A measured mode and the model's mode that is paired with it.
struct ModePair {
  int measured = 0;  ///< index into ModeSet::modes
  int model = 0;     ///< index into ModelModes
  double measured_hz = 0.0;
  double model_hz = 0.0;
  double error_percent = 0.0;  ///< (model - measured) / measured
  double mac = 0.0;
  double weighted_mac = 0.0;  ///< in the model's mass; see Comparison
  bool by_hand = false;
  bool has_shape = true;  ///< else, or of one or two values, MAC says nothing
};

struct BandError {
  double low_hz = 0.0;
  double high_hz = 0.0;
  double error = 0.0;
};

struct Comparison {
  double error = 0.0;  ///< relative FRF error on the comparison line
  /// What repeatability, mesh and form of the deck allow.
  double floor = 0.0;
  double floor_noise = 0.0;  ///< from the scatter over hits
  double floor_mesh = 0.0;   ///< half of what splitting the mesh changes
  /// Of what is left after a fit, see form_share(); of what is missing from a
  /// model, too, where no diagnosis has shown how little can be left.
  double floor_form = 0.0;
  std::string contour;  ///< the lines s it was evaluated on, in words
  std::vector<ModePair> pairs;
  /// What of the pairs by hand could not be kept to; why there is no MAC.
  std::vector<std::string> pair_notes;
  Eigen::MatrixXd mac;  ///< measured modes x model modes
  /// The same in the model's mass at the measured degrees of freedom.
  Eigen::MatrixXd weighted_mac;
  Eigen::VectorXd comac;  ///< per measured degree of freedom
  ModelModes modes;
  std::vector<double> frf_error;  ///< per FRF
  std::vector<double> frac;       ///< per FRF, 0..1
  std::vector<BandError> bands;
  std::map<int, double> point_error;  ///< per measured grid
  Eigen::MatrixXd frf_band_error;     ///< n_frf x n_bands
  /// Model on the lines of Session::frfs(), per FRF, for plotting.
  std::vector<Eigen::VectorXcd> model_frfs;
};

}  // namespace tapfit::updating
