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

void ModalTerm::turn_damping(const VectorXd& omega, const VectorXd& d) {
  if (K_.size() == 0 && M_.size() == 0) return;
  const VectorXd l = omega.cwiseAbs2();
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

// The real matrices multiply all lines at once, real and imaginary parts side
// by side.
MatrixXcd ModalTerm::times(const VectorXcd& s,
                           const DampingOfModes& damping,
                           const MatrixXcd& X) const {
  const Index n = X.cols();
  const VectorXd gained =
      damping.by_k.cwiseProduct(k_) + damping.by_m.cwiseProduct(m_);
  MatrixXcd result(X.rows(), n);
  for (Index c = 0; c < n; ++c) {
    VectorXcd d = s(c) * gained;
    if (K_.size() == 0) d += k_;
    if (M_.size() == 0) d += s(c) * s(c) * m_;
    result.col(c) = d.cwiseProduct(X.col(c));
  }
  MatrixXd parts(X.rows(), 2 * n);
  parts << X.real(), X.imag();
  const auto add = [&](const MatrixXd& A, int power) {
    if (A.size() == 0) return;
    const MatrixXd AX = A * parts;
    for (Index c = 0; c < n; ++c) {
      const complex<double> factor = std::pow(s(c), power);
      result.col(c).real() += factor.real() * AX.col(c);
      result.col(c).real() -= factor.imag() * AX.col(n + c);
      result.col(c).imag() += factor.imag() * AX.col(c);
      result.col(c).imag() += factor.real() * AX.col(n + c);
    }
  };
  add(K_, 0);
  add(C_, 1);
  add(M_, 2);
  return result;
}

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
MatrixXcd RunLines::coupling(complex<double> s, const VectorXcd& g) const {
  const Index k = B.cols();
  VectorXcd D(k);
  for (Index a = 0; a < k; ++a) {
    const Actor& actor = actors[static_cast<std::size_t>(a)];
    if (!actor.effect) {
      D(a) = s;
      continue;
    }
    const PlacedEffect& placed = shared->state->effects[*actor.effect];
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

void RunLines::respond(const VectorXcd& s,
                       const MatrixXcd& flexible,
                       ModelResponse& out) const {
  std::vector<Columns> X;
  for (Index line = 0; line < s.size(); ++line) {
    const VectorXcd g = flexible.col(line);
    const MatrixXcd coupled = B.cols() > 0 ? coupling(s(line), g) : MatrixXcd();
    Columns at;
    at.i = columns(g, coupled, references);
    const MatrixXcd H = responses.transpose() * at.i;
    for (const WalkedPair& p : pairs) {
      out.H(line, p.frf) = s(line) * s(line) * H(p.response, p.reference);
    }
    if (out.dH.empty()) continue;
    at.o = columns(g, coupled, responses);
    derive_damping(s(line), line, at, out);
    derive_law(s(line), line, at, out);
    derive_effects(s(line), line, at, out);
    X.push_back(std::move(at));
  }
  if (!out.dH.empty()) derive_terms(s, X, out);
}

void RunLines::derive_terms(const VectorXcd& s,
                            const std::vector<Columns>& X,
                            ModelResponse& out) const {
  if (shared->terms.empty()) return;
  // d Z is symmetric: it is multiplied to the side with fewer points.
  const bool few_responses = responses.cols() < references.cols();
  const Index n = few_responses ? responses.cols() : references.cols();
  MatrixXcd few(responses.rows(), n * s.size());
  VectorXcd line_of(few.cols());
  for (Index line = 0; line < s.size(); ++line) {
    const Columns& at = X[static_cast<std::size_t>(line)];
    few.middleCols(n * line, n) = few_responses ? at.o : at.i;
    line_of.segment(n * line, n).setConstant(s(line));
  }
  for (const ScaledTerm& scaled : shared->terms) {
    const MatrixXcd ZX = scaled.term.times(line_of, shared->damping, few);
    MatrixXcd& d = out.dH[scaled.column];
    for (Index line = 0; line < s.size(); ++line) {
      const Columns& at = X[static_cast<std::size_t>(line)];
      const auto of = ZX.middleCols(n * line, n);
      MatrixXcd change;
      if (few_responses) {
        change.noalias() = of.transpose() * at.i;
      } else {
        change.noalias() = at.o.transpose() * of;
      }
      const complex<double> factor = -scaled.scale * s(line) * s(line);
      for (const WalkedPair& p : pairs) {
        d(line, p.frf) = factor * change(p.response, p.reference);
      }
    }
  }
}

void RunLines::derive_damping(complex<double> s,
                              Index line,
                              const Columns& X,
                              ModelResponse& out) const {
  const VectorXd& d_of = shared->damping.d;
  for (Index m = 0; m < d_of.size(); ++m) {
    const int q = shared->owner[static_cast<std::size_t>(m)];
    if (q < 0) continue;
    const complex<double> dz = d_of(m) * s;
    MatrixXcd& d = out.dH[shared->first_zeta + static_cast<std::size_t>(q)];
    for (const WalkedPair& p : pairs) {
      d(line, p.frf) = -s * s * dz * X.o(m, p.response) * X.i(m, p.reference);
    }
  }
}

// The law gives every mode, the highest too, its share.
void RunLines::derive_law(complex<double> s,
                          Index line,
                          const Columns& X,
                          ModelResponse& out) const {
  const VectorXd& w = shared->modes.omega;
  for (std::size_t e = 0; e < shared->state->effects.size(); ++e) {
    const PlacedEffect& placed = shared->state->effects[e];
    if (placed.effect->entry() != effects::Entry::Damping) continue;
    for (std::size_t k = 0; k < placed.p.size(); ++k) {
      VectorXcd dz(w.size());
      for (Index m = 0; m < w.size(); ++m) {
        dz(m) = s * placed.p[k] * placed.effect->mode_damping(w(m), k).c;
      }
      const MatrixXcd change = X.o.transpose() * dz.asDiagonal() * X.i;
      MatrixXcd& d = out.dH[shared->first[e] + k];
      for (const WalkedPair& p : pairs) {
        d(line, p.frf) -= s * s * change(p.response, p.reference);
      }
    }
  }
}

void RunLines::derive_effects(complex<double> s,
                              Index line,
                              const Columns& X,
                              ModelResponse& out) const {
  const MatrixXcd BXo = B.transpose() * X.o;
  const MatrixXcd BXi = B.transpose() * X.i;
  for (std::size_t a = 0; a < actors.size(); ++a) {
    if (!actors[a].effect) continue;
    const PlacedEffect& placed = shared->state->effects[*actors[a].effect];
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      const complex<double> dz =
          actors[a].weight * placed.p[p] *
          placed.effect->law_derivative(s, placed.p, actors[a].group, p);
      MatrixXcd& d = out.dH[shared->first[*actors[a].effect] + p];
      const auto r = static_cast<Index>(a);
      for (const WalkedPair& q : pairs) {
        d(line, q.frf) -= s * s * dz * BXo(r, q.response) * BXi(r, q.reference);
      }
    }
  }
}

}  // namespace tapfit::updating
