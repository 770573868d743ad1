// How far a model is from measured modes.
//
//   frequency:  r = (f - f_measured) / sd
//   shape:      r = (u - a phi) / sqrt(sd^2 + v) at the m measured points
//
// A shape's factor a is the one that fits best: its scale and sign mean
// nothing, and least r is most MAC, with weights. A model is simpler than the
// structure, so that shapes miss by more than they scatter over repeated tests,
// and not more where they scatter more. v is that excess, in the same
// proportion to every shape; it is unknown and taken where the likelihood is
// largest (see shape_fit.hpp):
//
//   misfit = sum r_frequency^2 +
//            N / m min_(a, v) sum_shapes [ r^2 + ln(1 + v / sd^2) ]
//
// with N the independent readings of a shape: neighbours miss by the same.
#pragma once

#include "modal/mode_set/pairing.hpp"
#include "updating/modal_updating/scaled_parts.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct MeasuredModes {
  Eigen::VectorXd frequency_hz;  ///< p, each above 0
  Eigen::VectorXd frequency_sd;  ///< p [Hz], each above 0
  /// Rows of the model's matrices where shapes were measured; empty: none were.
  std::vector<int> dofs;
  Eigen::MatrixXd shape;     ///< dofs x p, real, of any scale
  Eigen::MatrixXd shape_sd;  ///< dofs x p in the units of `shape`, above 0
};

/// @param n degrees of freedom of the model
/// @throws InputError for sizes that do not agree, numbers that are not above 0
///   or not finite, a degree of freedom that the model does not have
void check(const MeasuredModes& measured, Eigen::Index n);

struct ModalResidual {
  /// Which mode of the model belongs to which measured one; see
  /// modal/mode_set/pairing.hpp. Without shapes the frequencies alone decide.
  std::vector<modal::Pair> pairs;
  Eigen::VectorXd frequency_hz;  ///< p, of the model; 0: unpaired
  Eigen::VectorXd mac;           ///< p, plain MAC; 0: unpaired or no shapes
  Eigen::VectorXd factor;        ///< p: a
  Eigen::VectorXd excess;        ///< p: sqrt(v), in the units of the shape
  Eigen::VectorXd r;             ///< p frequencies, then p shapes one by one
  Eigen::VectorXd weight;        ///< of each r^2: 1, or N / m
  /// A measured mode without a partner counts as one at the limit of pairing
  /// with a = 0 and an excess of its own.
  double misfit = 0.0;
};

/// @param independent N, from 1 to m
[[nodiscard]] ModalResidual modal_residual(const MeasuredModes& measured,
                                           const structure::Eigenmodes& modes,
                                           const modal::PairingOptions& pairing,
                                           double independent);

/// d r / d theta at the v found, rows as in r; zero for modes without a
/// partner. The slope of the misfit is 2 J' (weight r), v being at its best.
/// @param modes those of the residual, at theta
[[nodiscard]] Eigen::MatrixXd modal_jacobian(const ScaledModel& model,
                                             const Eigen::VectorXd& theta,
                                             const MeasuredModes& measured,
                                             const structure::Eigenmodes& modes,
                                             const ModalResidual& residual);

}  // namespace tapfit::updating
