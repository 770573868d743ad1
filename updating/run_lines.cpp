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
    const PlacedEffect& placed = shared->beside[*actor.effect];
    D(a) = actor.weight * placed.effect->law(s, placed.p, actor.group);
  }
  MatrixXcd core = B.transpose() * (g.asDiagonal() * B) * D.asDiagonal();
  core.diagonal().array() += 1.0;
  return D.asDiagonal() * core.inverse();
}

RunLines::Columns RunLines::columns(const VectorXcd& g,
                                    const MatrixXcd& coupled,
                                    const MatrixXd& points) const {
  Columns of{g.asDiagonal() * points, {}};
  if (B.cols() == 0) return of;
  of.u = coupled * (B.transpose() * of.X);
  of.X.noalias() -= g.asDiagonal() * (B * of.u);
  return of;
}

void RunLines::respond(const VectorXcd& s,
                       const MatrixXcd& flexible,
                       ModelResponse& out) const {
  std::vector<Turned> turned;
  if (!out.dH.empty()) {
    for (const TurningParameter& p : shared->turning) {
      turned.push_back({p.turn.turned(responses),
                        p.turn.turned(references),
                        p.turn.turned(B)});
    }
  }
  for (Index at = 0; at < s.size(); ++at) {
    const VectorXcd g = flexible.col(at);
    const MatrixXcd coupled = B.cols() > 0 ? coupling(s(at), g) : MatrixXcd();
    Line line{s(at), at, {}, columns(g, coupled, references)};
    const MatrixXcd H = responses.transpose() * line.i.X;
    for (const WalkedPair& p : pairs) {
      out.H(at, p.frf) = s(at) * s(at) * H(p.response, p.reference);
    }
    if (out.dH.empty()) continue;
    line.o = columns(g, coupled, responses);
    derive_damping(line, out);
    derive_law(line, out);
    derive_effects(line, out);
    derive_turning(line, turned, out);
  }
}

// H_oi = c_o' R' G R c_i with the modal rows R of the points and of B, and
// X_q = G R c_q: where the modes turn by A,
//   d H_oi = Y_o' X_i + X_o' (Y_i - diag(d lambda + s d d) X_i),
//   Y_q = A' R c_q.
void RunLines::derive_turning(const Line& line,
                              const std::vector<Turned>& turned,
                              ModelResponse& out) const {
  for (std::size_t t = 0; t < turned.size(); ++t) {
    const TurningParameter& p = shared->turning[t];
    MatrixXcd Yo = turned[t].responses.cast<complex<double>>();
    MatrixXcd Yi = turned[t].references.cast<complex<double>>();
    if (B.cols() > 0) {
      Yo.noalias() -= turned[t].B * line.o.u;
      Yi.noalias() -= turned[t].B * line.i.u;
    }
    Yi -= p.turn.stiffened(line.s).asDiagonal() * line.i.X;
    MatrixXcd change = Yo.transpose() * line.i.X;
    change.noalias() += line.o.X.transpose() * Yi;
    p.turn.take_close(line.s, line.o.X, line.i.X, change);
    MatrixXcd& d = out.dH[p.column];
    const complex<double> factor = p.scale * line.s * line.s;
    for (const WalkedPair& q : pairs) {
      d(line.at, q.frf) = factor * change(q.response, q.reference);
    }
  }
}

void RunLines::derive_damping(const Line& line, ModelResponse& out) const {
  const VectorXd& d_of = shared->damping.d;
  for (Index m = 0; m < d_of.size(); ++m) {
    const int q = shared->owner[static_cast<std::size_t>(m)];
    if (q < 0) continue;
    const complex<double> z = -line.s * line.s * line.s * d_of(m);
    MatrixXcd& d = out.dH[shared->first_zeta + static_cast<std::size_t>(q)];
    for (const WalkedPair& p : pairs) {
      d(line.at, p.frf) =
          z * line.o.X(m, p.response) * line.i.X(m, p.reference);
    }
  }
}

// The law gives every mode, the highest too, its share.
void RunLines::derive_law(const Line& line, ModelResponse& out) const {
  const complex<double> s = line.s;
  const VectorXd& w = shared->modes.omega;
  for (std::size_t e = 0; e < shared->state->effects.size(); ++e) {
    const PlacedEffect& placed = shared->state->effects[e];
    if (placed.effect->entry() != effects::Entry::Damping) continue;
    for (std::size_t k = 0; k < placed.p.size(); ++k) {
      VectorXcd dz(w.size());
      for (Index m = 0; m < w.size(); ++m) {
        dz(m) = s * placed.p[k] * placed.effect->mode_damping(w(m), k).c;
      }
      const MatrixXcd change =
          line.o.X.transpose() * dz.asDiagonal() * line.i.X;
      MatrixXcd& d = out.dH[shared->first[e] + k];
      for (const WalkedPair& p : pairs) {
        d(line.at, p.frf) -= s * s * change(p.response, p.reference);
      }
    }
  }
}

void RunLines::derive_effects(const Line& line, ModelResponse& out) const {
  const complex<double> s = line.s;
  const MatrixXcd BXo = B.transpose() * line.o.X;
  const MatrixXcd BXi = B.transpose() * line.i.X;
  for (std::size_t a = 0; a < actors.size(); ++a) {
    if (!actors[a].effect) continue;
    // What is in the modes is zero here, and so is its slope.
    const PlacedEffect& placed = shared->beside[*actors[a].effect];
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      const complex<double> dz =
          actors[a].weight * placed.p[p] *
          placed.effect->law_derivative(s, placed.p, actors[a].group, p);
      MatrixXcd& d = out.dH[shared->first[*actors[a].effect] + p];
      const auto r = static_cast<Index>(a);
      for (const WalkedPair& q : pairs) {
        d(line.at, q.frf) -=
            s * s * dz * BXo(r, q.response) * BXi(r, q.reference);
      }
    }
  }
}

}  // namespace tapfit::updating
