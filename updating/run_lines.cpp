#include "updating/run_lines.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

namespace {

bool is_diagonal(const MatrixXd& A) {
  const double off = (A - MatrixXd(A.diagonal().asDiagonal())).norm();
  return off <= 1e-9 * A.norm();
}

}  // namespace

ModalTerm::ModalTerm(const MatrixXd& phi, const MatrixXd& K, const MatrixXd* M)
    : K_(phi.transpose() * K * phi) {
  k_ = K_.diagonal();
  m_ = VectorXd::Zero(k_.size());
  if (is_diagonal(K_)) K_.resize(0, 0);
  if (M == nullptr || M->isZero(0.0)) return;
  M_ = phi.transpose() * *M * phi;
  m_ = M_.diagonal();
  if (is_diagonal(M_)) M_.resize(0, 0);
}

void ModalTerm::turn_damping(const VectorXd& omega, const VectorXd& zeta) {
  if (K_.size() == 0 && M_.size() == 0) return;
  const VectorXd l = omega.cwiseAbs2();
  const VectorXd d = 2.0 * zeta.cwiseProduct(omega);
  C_ = MatrixXd::Zero(l.size(), l.size());
  for (Index j = 0; j < l.size(); ++j) {
    for (Index i = 0; i < l.size(); ++i) {
      // Modes of one frequency have no direction of their own to turn to.
      if (std::abs(l(j) - l(i)) <= 1e-9 * std::max(l(i), l(j))) continue;
      const double k = K_.size() > 0 ? K_(i, j) : 0.0;
      const double m = M_.size() > 0 ? M_(i, j) : 0.0;
      C_(i, j) =
          (k * (d(j) - d(i)) + m * (l(j) * d(i) - l(i) * d(j))) / (l(j) - l(i));
    }
  }
}

MatrixXcd ModalTerm::times(complex<double> s,
                           const VectorXd& omega,
                           const VectorXd& zeta,
                           const MatrixXcd& X) const {
  VectorXcd d(omega.size());
  for (Index m = 0; m < d.size(); ++m) {
    // c = 2 zeta sqrt(k m) grows with half of either.
    d(m) = s * zeta(m) * omega(m) * m_(m);
    if (omega(m) > 0.0) d(m) += s * zeta(m) / omega(m) * k_(m);
    if (K_.size() == 0) d(m) += k_(m);
    if (M_.size() == 0) d(m) += s * s * m_(m);
  }
  MatrixXcd result = d.asDiagonal() * X;
  if (K_.size() > 0) result += K_ * X;
  if (M_.size() > 0) result += s * s * (M_ * X);
  if (C_.size() > 0) result += s * (C_ * X);
  return result;
}

VectorXcd flexibility(const ModalState& shared, complex<double> s) {
  const VectorXd& w = shared.modes.omega;
  VectorXcd g(w.size());
  for (Index m = 0; m < w.size(); ++m) {
    g(m) = 1.0 / (s * s + 2.0 * shared.zeta(m) * w(m) * s + w(m) * w(m));
  }
  return g;
}

// Passive effects on a line with sigma > 0 keep the core regular.
MatrixXcd RunLines::coupling(complex<double> s, const VectorXcd& g) const {
  const Index k = B.cols();
  VectorXcd D(k);
  for (Index a = 0; a < k; ++a) {
    const Actor& actor = actors[static_cast<std::size_t>(a)];
    const PlacedEffect& placed = shared->state->effects[actor.effect];
    D(a) = actor.weight * placed.effect->law(s, placed.p, actor.group);
  }
  MatrixXcd core = B.transpose() * (g.asDiagonal() * B) * D.asDiagonal();
  core.diagonal().array() += 1.0;
  return D.asDiagonal() * core.inverse();
}

MatrixXcd RunLines::columns(const VectorXcd& g,
                            const MatrixXcd& coupled,
                            const MatrixXd& points) const {
  MatrixXcd X = g.asDiagonal() * points;
  if (B.cols() == 0) return X;
  const MatrixXcd inner = coupled * (B.transpose() * X);
  X.noalias() -= g.asDiagonal() * (B * inner);
  return X;
}

void RunLines::respond(complex<double> s,
                       const VectorXcd& g,
                       Index line,
                       ModelResponse& out) const {
  const MatrixXcd coupled = B.cols() > 0 ? coupling(s, g) : MatrixXcd();
  const MatrixXcd Xi = columns(g, coupled, references);
  const MatrixXcd H = s * s * (responses.transpose() * Xi);
  for (const WalkedPair& p : pairs) {
    out.H(line, p.frf) = H(p.response, p.reference);
  }
  if (out.dH.empty()) return;
  const MatrixXcd Xo = columns(g, coupled, responses);
  derive_terms(s, line, Xo, Xi, out);
  derive_damping(s, line, Xo, Xi, out);
  derive_effects(s, line, Xo, Xi, out);
}

void RunLines::derive_terms(complex<double> s,
                            Index line,
                            const MatrixXcd& Xo,
                            const MatrixXcd& Xi,
                            ModelResponse& out) const {
  // d Z is symmetric: it is multiplied to the side with fewer points.
  const bool few_responses = Xo.cols() < Xi.cols();
  const MatrixXcd& few = few_responses ? Xo : Xi;
  for (const ScaledTerm& scaled : shared->terms) {
    const MatrixXcd ZX =
        scaled.term.times(s, shared->modes.omega, shared->zeta, few);
    const complex<double> factor = -scaled.scale * s * s;
    const MatrixXcd change = few_responses
                                 ? MatrixXcd(factor * (ZX.transpose() * Xi))
                                 : MatrixXcd(factor * (Xo.transpose() * ZX));
    MatrixXcd& d = out.dH[scaled.column];
    for (const WalkedPair& p : pairs) {
      d(line, p.frf) = change(p.response, p.reference);
    }
  }
}

void RunLines::derive_damping(complex<double> s,
                              Index line,
                              const MatrixXcd& Xo,
                              const MatrixXcd& Xi,
                              ModelResponse& out) const {
  const VectorXd& w = shared->modes.omega;
  for (Index m = 0; m < w.size(); ++m) {
    const int q = shared->owner[static_cast<std::size_t>(m)];
    if (q < 0) continue;
    const complex<double> dz = 2.0 * shared->zeta(m) * w(m) * s;
    MatrixXcd& d = out.dH[shared->first_zeta + static_cast<std::size_t>(q)];
    for (const WalkedPair& p : pairs) {
      d(line, p.frf) = -s * s * dz * Xo(m, p.response) * Xi(m, p.reference);
    }
  }
}

void RunLines::derive_effects(complex<double> s,
                              Index line,
                              const MatrixXcd& Xo,
                              const MatrixXcd& Xi,
                              ModelResponse& out) const {
  const MatrixXcd BXo = B.transpose() * Xo;
  const MatrixXcd BXi = B.transpose() * Xi;
  for (std::size_t a = 0; a < actors.size(); ++a) {
    const PlacedEffect& placed = shared->state->effects[actors[a].effect];
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      const complex<double> dz =
          actors[a].weight * placed.p[p] *
          placed.effect->law_derivative(s, placed.p, actors[a].group, p);
      MatrixXcd& d = out.dH[shared->first[actors[a].effect] + p];
      const auto r = static_cast<Index>(a);
      for (const WalkedPair& q : pairs) {
        d(line, q.frf) -= s * s * dz * BXo(r, q.response) * BXi(r, q.reference);
      }
    }
  }
}

}  // namespace tapfit::updating
