// A chain of springs and masses, and its modes as a perfect test finds them.
#pragma once

#include "updating/modal_updating/modal_residual.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

namespace tapfit::updating::support {

// Masses of 2 kg in a row, each held by a spring of 5000 N/m to the one before
// it; the first to the ground. One part per spring, `masses` more per mass.
inline ScaledModel chain(Eigen::Index n, Eigen::Index masses = 0) {
  ScaledModel model;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(n, n);
    part(j, j) = 5000.0;
    if (j > 0) {
      part(j - 1, j - 1) = 5000.0;
      part(j - 1, j) = part(j, j - 1) = -5000.0;
    }
    K += part;
    model.parts.push_back({fmt::format("spring {}", j + 1), part.sparseView()});
  }
  const Eigen::MatrixXd M = 2.0 * Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index j = 0; j < masses; ++j) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(n, n);
    part(j, j) = 2.0;
    model.parts.push_back(
        {fmt::format("mass {}", j + 1), {}, part.sparseView()});
  }
  model.K0 = K.sparseView();
  model.M0 = M.sparseView();
  return model;
}

inline structure::Eigenmodes modes_of(const ScaledModel& model,
                                      const Eigen::VectorXd& theta,
                                      Eigen::Index count) {
  return structure::eigenmodes(
      model.stiffness(theta), model.mass(theta), count);
}

// The lowest modes at some degrees of freedom, as a perfect test finds
// them.
inline MeasuredModes measure(const ScaledModel& model,
                             const Eigen::VectorXd& theta,
                             Eigen::Index count,
                             int every = 1) {
  const structure::Eigenmodes modes = modes_of(model, theta, count);
  MeasuredModes measured;
  measured.frequency_hz = modes.frequency_hz;
  measured.frequency_sd = 1e-3 * modes.frequency_hz;
  for (int i = 0; i < model.K0.rows(); i += every) measured.dofs.push_back(i);
  measured.shape.resize(static_cast<Eigen::Index>(measured.dofs.size()), count);
  for (Eigen::Index i = 0; i < measured.shape.rows(); ++i) {
    measured.shape.row(i) =
        modes.phi.row(measured.dofs[static_cast<std::size_t>(i)]);
  }
  // Scale and sign mean nothing.
  for (Eigen::Index k = 0; k < count; ++k) {
    measured.shape.col(k) *= (k % 2 == 0 ? -1.7 : 0.3);
  }
  measured.shape_sd =
      Eigen::MatrixXd::Constant(measured.shape.rows(), count, 0.0);
  for (Eigen::Index k = 0; k < count; ++k) {
    measured.shape_sd.col(k).setConstant(
        0.02 * measured.shape.col(k).cwiseAbs().maxCoeff());
  }
  return measured;
}

}  // namespace tapfit::updating::support
