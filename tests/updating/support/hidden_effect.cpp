#include "tests/updating/support/hidden_effect.hpp"

#include "tests/updating/support/sizes.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace tapfit::updating::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd phi_at(const signal::HungStructure& structure, std::size_t point) {
  VectorXd phi(static_cast<Index>(structure.modes.size()));
  for (Index k = 0; k < phi.size(); ++k) {
    phi(k) = structure.modes[static_cast<std::size_t>(k)].phi[point];
  }
  return phi;
}

// The first frequency that is no rigid body's on its strings [rad/s].
double first_elastic(const VectorXd& w) {
  constexpr double strings_hz = 2.0;
  for (const double one : w) {
    if (one > 2.0 * std::numbers::pi * strings_hz) return one;
  }
  return w.maxCoeff();
}

/// dK and dM in the coordinates of the modes.
struct Change {
  MatrixXd K;
  MatrixXd M;
};

Change change_of(const signal::HungStructure& bare,
                 const HiddenEffect& effect,
                 const VectorXd& w,
                 double mass_kg) {
  const Index n = w.size();
  Change change{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
  const VectorXd phi = phi_at(bare, effect.point);
  switch (effect.kind) {
    case Hidden::None:
      break;
    case Hidden::PointMass:
      change.M += mass_of(effect, mass_kg) * phi * phi.transpose();
      break;
    case Hidden::SensorMasses:
      for (const std::size_t at : bare.sensors) {
        const VectorXd there = phi_at(bare, at);
        change.M += mass_of(effect, mass_kg) * there * there.transpose();
      }
      break;
    case Hidden::GroundSpring:
      change.K += between(0.01, 1.0, effect.size) * mass_kg *
                  std::pow(first_elastic(w), 2) * phi * phi.transpose();
      break;
    case Hidden::Softened: {
      // The curvature of a mode is w phi (exactly so where modes are sines);
      // a share of all stiffness against it is lost.
      const VectorXd bent = w.cwiseProduct(phi);
      change.K -= between(0.02, 0.5, effect.size) * bent * bent.transpose() /
                  phi.squaredNorm();
      break;
    }
  }
  return change;
}

}  // namespace

double mass_of(const HiddenEffect& effect, double mass_kg) {
  switch (effect.kind) {
    case Hidden::PointMass:
      return between(0.01, 0.2, effect.size) * mass_kg;
    case Hidden::SensorMasses:
      return between(0.003, 0.03, effect.size) * mass_kg;
    default:
      return 0.0;
  }
}

signal::HungStructure with_effect(const signal::HungStructure& bare,
                                  const HiddenEffect& effect,
                                  double mass_kg) {
  if (effect.kind == Hidden::None) return bare;
  const auto n = static_cast<Index>(bare.modes.size());
  VectorXd w(n);
  VectorXd damping(n);
  for (Index k = 0; k < n; ++k) {
    const signal::StructureMode& mode = bare.modes[static_cast<std::size_t>(k)];
    w(k) = 2.0 * std::numbers::pi * mode.hz;
    damping(k) = 2.0 * mode.zeta * w(k);
  }
  const Change change = change_of(bare, effect, w, mass_kg);
  const MatrixXd K = MatrixXd(w.cwiseAbs2().asDiagonal()) + change.K;
  const MatrixXd M = MatrixXd::Identity(n, n) + change.M;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(K, M);
  signal::HungStructure changed = bare;
  for (Index k = 0; k < n; ++k) {
    const VectorXd q = eigen.eigenvectors().col(k);
    signal::StructureMode& mode = changed.modes[static_cast<std::size_t>(k)];
    const double to = std::sqrt(eigen.eigenvalues()(k));
    mode.hz = to / (2.0 * std::numbers::pi);
    mode.zeta = q.cwiseAbs2().dot(damping) / (2.0 * to);
    for (std::size_t at = 0; at < mode.phi.size(); ++at) {
      mode.phi[at] = q.dot(phi_at(bare, at));
    }
  }
  return changed;
}

}  // namespace tapfit::updating::testing
