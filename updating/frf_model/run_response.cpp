#include "updating/frf_model/run_response.hpp"

#include <Eigen/LU>

#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

MatrixXcd flexibility(const ModalState& shared, const VectorXcd& s) {
  const VectorXd& w = shared.modes.omega;
  MatrixXcd g(w.size(), s.size());
  for (Index l = 0; l < s.size(); ++l) {
    for (Index m = 0; m < w.size(); ++m) {
      g(m, l) = 1.0 / (s(l) * s(l) + shared.damping.d(m) * s(l) + w(m) * w(m));
    }
  }
  return g;
}

// Passive effects on a line with sigma > 0 keep the core regular.
MatrixXcd RunResponse::coupling(complex<double> s,
                                const MatrixXcd& receptance) const {
  const Index k = B.cols();
  VectorXcd D(k);
  for (Index a = 0; a < k; ++a) {
    const CoupledDof& actor = actors[static_cast<std::size_t>(a)];
    if (!actor.effect) {
      D(a) = s;
      continue;
    }
    const EffectInstance& placed = shared->beside[*actor.effect];
    D(a) = actor.weight * placed.effect->law(s, placed.p, actor.group);
  }
  MatrixXcd core = receptance * D.asDiagonal();
  core.diagonal().array() += 1.0;
  return D.asDiagonal() * core.inverse();
}

MatrixXcd RunResponse::columns(const VectorXcd& g,
                               const MatrixXcd& coupled,
                               const MatrixXd& points) const {
  MatrixXcd X = g.asDiagonal() * points;
  if (B.cols() == 0) return X;
  const MatrixXcd u = coupled * (B.transpose() * X);
  X.noalias() -= g.asDiagonal() * (B * u);
  return X;
}

}  // namespace tapfit::updating
