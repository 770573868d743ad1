#include "updating/frf_model.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

// A degree of freedom acted on, with the effect that does.
struct Actor {
  std::size_t effect = 0;
  std::size_t group = 0;
  double weight = 1.0;
};

BaseModes solve_modes(const MatrixXd& K, const MatrixXd& M) {
  BaseModes modes;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, M);
  modes.omega = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  modes.phi = solver.eigenvectors();
  return modes;
}

}  // namespace

Index ModelState::parameters() const {
  Index n = static_cast<Index>(factor.size()) + zeta.size();
  for (const PlacedEffect& e : effects) n += static_cast<Index>(e.p.size());
  return n;
}

VectorXd pack(const ModelState& state) {
  VectorXd theta(state.parameters());
  Index k = 0;
  for (const double f : state.factor) theta(k++) = std::log(f);
  for (const double z : state.zeta) theta(k++) = std::log(z);
  for (const PlacedEffect& e : state.effects) {
    for (const double p : e.p) theta(k++) = std::log(p);
  }
  return theta;
}

ModelState unpack(const ModelState& like, const VectorXd& theta) {
  ModelState state = like;
  Index k = 0;
  for (double& f : state.factor) f = std::exp(theta(k++));
  for (double& z : state.zeta) z = std::exp(theta(k++));
  for (PlacedEffect& e : state.effects) {
    for (double& p : e.p) p = std::exp(theta(k++));
  }
  return state;
}

FrfModel::FrfModel(ReducedBase base,
                   const effects::Setting& setting,
                   const signal::FrfSet& measured)
    : base_(std::move(base)), setting_(setting) {
  std::map<std::size_t, std::vector<std::size_t>> runs;
  for (const signal::Frf& frf : measured.frfs) {
    Pair pair;
    pair.run = frf.run;
    pair.channel = setting.bundle->channels.at(frf.channel).name;
    pair.response = frf.response.sign *
                    row(frf.response.node, frf.response.component).transpose();
    pair.reference =
        frf.reference.sign *
        row(frf.reference.node, frf.reference.component).transpose();
    runs[frf.run].push_back(pairs_.size());
    pairs_.push_back(std::move(pair));
  }
  for (auto& [run, members] : runs) by_run_.push_back(std::move(members));
}

Eigen::RowVectorXd FrfModel::row(int node, int component) const {
  const auto grid = static_cast<Index>(setting_.deck->grid_index(node));
  return base_.rows.row(6 * grid + component - 1);
}

BaseModes FrfModel::base_modes(const ModelState& state) const {
  MatrixXd K = base_.K;
  MatrixXd M = MatrixXd::Identity(base_.size(), base_.size());
  for (std::size_t j = 0; j < state.factor.size(); ++j) {
    K += (state.factor[j] - 1.0) * base_.K_part[j];
    M += (state.factor[j] - 1.0) * base_.M_part[j];
  }
  for (const SupportTerm& term : base_.supports) {
    double k = term.stiff;
    for (const PlacedEffect& e : state.effects) {
      if (e.effect->entry() == effects::Entry::Support &&
          e.where == term.where) {
        k = e.p[0];
      }
    }
    K += k * term.S;
  }
  return solve_modes(K, M);
}

BaseModes FrfModel::full_modes(const ModelState& state) const {
  const BaseModes base = base_modes(state);
  MatrixXd K = base.omega.cwiseAbs2().asDiagonal();
  MatrixXd M = MatrixXd::Identity(K.rows(), K.cols());
  // Split a real law into stiffness and mass at the middle of the band.
  const double omega =
      2.0 * M_PI * std::sqrt(setting_.low_hz * setting_.high_hz);
  for (const PlacedEffect& e : state.effects) {
    if (e.effect->entry() != effects::Entry::LowRank) continue;
    for (const effects::ActedDof& dof :
         e.effect->acts_on(e.where, setting_, 0)) {
      const VectorXd b =
          base.phi.transpose() * row(dof.node, dof.component).transpose();
      const double k = e.effect->law(0.0, e.p, dof.group).real() * dof.weight;
      const double z =
          e.effect->law({0.0, omega}, e.p, dof.group).real() * dof.weight;
      K += k * b * b.transpose();
      M += (k - z) / (omega * omega) * b * b.transpose();
    }
  }
  BaseModes full = solve_modes(K, M);
  full.phi = (base.phi * full.phi).eval();
  return full;
}

void FrfModel::set_reference(const ModelState& state) {
  reference_phi_ = base_modes(state).phi;
}

// Damping ratio of every mode; owner[q] is the index of its parameter or -1.
VectorXd FrfModel::damping(const ModelState& state,
                           const BaseModes& modes,
                           std::vector<int>& owner) const {
  const Index count = std::min<Index>(state.zeta.size(), modes.omega.size());
  VectorXd zeta = VectorXd::Constant(modes.omega.size(), state.zeta_other);
  owner.assign(static_cast<std::size_t>(modes.omega.size()), -1);
  if (reference_phi_.size() == 0) {
    for (Index q = 0; q < count; ++q) {
      owner[static_cast<std::size_t>(q)] = static_cast<int>(q);
    }
  } else {
    const MatrixXd overlap =
        (reference_phi_.leftCols(count).transpose() * modes.phi).cwiseAbs();
    for (Index q = 0; q < count; ++q) {
      Index best = 0;
      overlap.row(q).maxCoeff(&best);
      owner[static_cast<std::size_t>(best)] = static_cast<int>(q);
    }
  }
  for (Index m = 0; m < zeta.size(); ++m) {
    const int q = owner[static_cast<std::size_t>(m)];
    if (q >= 0) zeta(m) = state.zeta(q);
  }
  return zeta;
}

// What one run needs on every line: its effects and its points.
struct FrfModel::RunLines {
  const FrfModel* model = nullptr;
  const ModelState* state = nullptr;
  const BaseModes* modes = nullptr;
  VectorXd zeta;
  std::vector<int> owner;
  std::vector<Actor> actors;
  MatrixXd B;  // m x k, rows of the actors in modal coordinates
  std::vector<std::size_t> pairs;
  MatrixXd responses;            // m x n
  MatrixXd references;           // m x n
  std::vector<MatrixXd> K_part;  // in modal coordinates, shared by all runs
  std::vector<MatrixXd> M_part;
  std::vector<std::size_t> support_effects;
  std::vector<MatrixXd> S;

  void collect(std::size_t run);
  [[nodiscard]] VectorXcd flexibility(complex<double> s) const;
  [[nodiscard]] MatrixXcd coupling(complex<double> s, const VectorXcd& g) const;
  [[nodiscard]] MatrixXcd woodbury(complex<double> s,
                                   const VectorXcd& g,
                                   const MatrixXd& points) const;
  void respond(complex<double> s,
               Index line,
               bool derivatives,
               ModelResponse& out) const;
  void derive(complex<double> s,
              Index line,
              const MatrixXcd& Xo,
              const MatrixXcd& Xi,
              ModelResponse& out) const;
};

void FrfModel::RunLines::collect(std::size_t run) {
  std::vector<VectorXd> rows;
  for (std::size_t e = 0; e < state->effects.size(); ++e) {
    const PlacedEffect& placed = state->effects[e];
    if (placed.effect->entry() != effects::Entry::LowRank) continue;
    for (const effects::ActedDof& dof :
         placed.effect->acts_on(placed.where, model->setting_, run)) {
      const VectorXd b = modes->phi.transpose() *
                         model->row(dof.node, dof.component).transpose();
      if (b.squaredNorm() < 1e-18) continue;  // held, or out of the base
      actors.push_back({e, dof.group, dof.weight});
      rows.push_back(b);
    }
  }
  B.resize(modes->omega.size(), static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    B.col(static_cast<Index>(k)) = rows[k];
  }
  const auto n = static_cast<Index>(pairs.size());
  responses.resize(modes->omega.size(), n);
  references.resize(modes->omega.size(), n);
  for (Index k = 0; k < n; ++k) {
    const Pair& pair = model->pairs_[pairs[static_cast<std::size_t>(k)]];
    responses.col(k) = modes->phi.transpose() * pair.response;
    references.col(k) = modes->phi.transpose() * pair.reference;
  }
}

VectorXcd FrfModel::RunLines::flexibility(complex<double> s) const {
  const VectorXd& w = modes->omega;
  VectorXcd g(w.size());
  for (Index m = 0; m < w.size(); ++m) {
    g(m) = 1.0 / (s * s + 2.0 * zeta(m) * w(m) * s + w(m) * w(m));
  }
  return g;
}

// D (I + B' H B D)^-1 of eq. 15. Passive effects on a line with sigma > 0 keep
// the core regular.
MatrixXcd FrfModel::RunLines::coupling(complex<double> s,
                                       const VectorXcd& g) const {
  const Index k = B.cols();
  VectorXcd D(k);
  for (Index a = 0; a < k; ++a) {
    const Actor& actor = actors[static_cast<std::size_t>(a)];
    const PlacedEffect& placed = state->effects[actor.effect];
    D(a) = actor.weight * placed.effect->law(s, placed.p, actor.group);
  }
  MatrixXcd core = B.transpose() * (g.asDiagonal() * B) * D.asDiagonal();
  core.diagonal().array() += 1.0;
  return D.asDiagonal() * core.inverse();
}

// X = H* e for the points, in modal coordinates (eq. 15).
MatrixXcd FrfModel::RunLines::woodbury(complex<double> s,
                                       const VectorXcd& g,
                                       const MatrixXd& points) const {
  MatrixXcd X = g.asDiagonal() * points;
  if (B.cols() == 0) return X;
  const MatrixXcd inner = coupling(s, g) * (B.transpose() * X);
  X.noalias() -= g.asDiagonal() * (B * inner);
  return X;
}

void FrfModel::RunLines::respond(complex<double> s,
                                 Index line,
                                 bool derivatives,
                                 ModelResponse& out) const {
  const VectorXcd g = flexibility(s);
  const MatrixXcd Xi = woodbury(s, g, references);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto c = static_cast<Index>(k);
    out.H(line, static_cast<Index>(pairs[k])) =
        s * s *
        responses.col(c).cast<complex<double>>().cwiseProduct(Xi.col(c)).sum();
  }
  if (derivatives) derive(s, line, woodbury(s, g, responses), Xi, out);
}

void FrfModel::RunLines::derive(complex<double> s,
                                Index line,
                                const MatrixXcd& Xo,
                                const MatrixXcd& Xi,
                                ModelResponse& out) const {
  const VectorXd& w = modes->omega;
  const auto factors = static_cast<Index>(state->factor.size());
  const Index dampings = state->zeta.size();
  // d Z / d f in modal coordinates; the damping follows the frequencies.
  const auto through =
      [&](const MatrixXd& dK, const MatrixXd* dM, Index column, double scale) {
        VectorXcd damp(w.size());
        for (Index m = 0; m < w.size(); ++m) {
          damp(m) = w(m) > 0.0 ? s * zeta(m) / w(m) * dK(m, m) : 0.0;
          // omega^2 = k / m: the mass acts on the frequency with the other
          // sign.
          if (dM != nullptr) damp(m) += s * zeta(m) * w(m) * (*dM)(m, m);
        }
        MatrixXcd ZX = dK * Xi;
        if (dM != nullptr) ZX += s * s * (*dM * Xi);
        ZX += damp.asDiagonal() * Xi;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
          const auto c = static_cast<Index>(k);
          out.dH[static_cast<std::size_t>(column)](
              line, static_cast<Index>(pairs[k])) =
              -scale * s * s * Xo.col(c).cwiseProduct(ZX.col(c)).sum();
        }
      };
  for (Index j = 0; j < factors; ++j) {
    const auto at = static_cast<std::size_t>(j);
    through(K_part[at], &M_part[at], j, state->factor[at]);
  }
  for (Index m = 0; m < w.size(); ++m) {
    const int q = owner[static_cast<std::size_t>(m)];
    if (q < 0) continue;
    const complex<double> dz = 2.0 * zeta(m) * w(m) * s;
    MatrixXcd& d = out.dH[static_cast<std::size_t>(factors + q)];
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto c = static_cast<Index>(k);
      d(line, static_cast<Index>(pairs[k])) = -s * s * dz * Xo(m, c) * Xi(m, c);
    }
  }
  Index column = factors + dampings;
  std::vector<Index> first;
  for (const PlacedEffect& e : state->effects) {
    first.push_back(column);
    column += static_cast<Index>(e.p.size());
  }
  for (std::size_t e = 0; e < support_effects.size(); ++e) {
    const std::size_t effect = support_effects[e];
    through(S[e], nullptr, first[effect], state->effects[effect].p[0]);
  }
  const MatrixXcd BXo = B.transpose() * Xo;
  const MatrixXcd BXi = B.transpose() * Xi;
  for (std::size_t a = 0; a < actors.size(); ++a) {
    const PlacedEffect& placed = state->effects[actors[a].effect];
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      const complex<double> dz =
          actors[a].weight * placed.p[p] *
          placed.effect->law_derivative(s, placed.p, actors[a].group, p);
      MatrixXcd& d = out.dH[static_cast<std::size_t>(first[actors[a].effect] +
                                                     static_cast<Index>(p))];
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto c = static_cast<Index>(k);
        const auto r = static_cast<Index>(a);
        d(line, static_cast<Index>(pairs[k])) -=
            s * s * dz * BXo(r, c) * BXi(r, c);
      }
    }
  }
}

std::vector<FrfModel::Columns> FrfModel::columns(
    const ModelState& state,
    const VectorXcd& s,
    std::size_t run,
    const MatrixXd& points,
    const MatrixXd& candidates) const {
  const BaseModes modes = base_modes(state);
  RunLines lines;
  lines.model = this;
  lines.state = &state;
  lines.modes = &modes;
  lines.zeta = damping(state, modes, lines.owner);
  lines.collect(run);
  const MatrixXd at = modes.phi.transpose() * points;
  const MatrixXd of = modes.phi.transpose() * candidates;
  const MatrixXd squares = of.cwiseAbs2();
  std::vector<Columns> result;
  for (Index line = 0; line < s.size(); ++line) {
    const VectorXcd g = lines.flexibility(s(line));
    Columns c;
    c.X = modes.phi * lines.woodbury(s(line), g, at);
    c.own = squares.transpose() * g;
    if (lines.B.cols() > 0) {
      // diag(of' H* of) = diag(of' G of) - what the effects take away
      const MatrixXcd inner = lines.coupling(s(line), g);
      const MatrixXcd GBc = of.transpose() * (g.asDiagonal() * lines.B);
      c.own -= (GBc * inner).cwiseProduct(GBc).rowwise().sum();
    }
    result.push_back(std::move(c));
  }
  return result;
}

ModelResponse FrfModel::respond(const ModelState& state,
                                const VectorXcd& s,
                                bool derivatives) const {
  const BaseModes modes = base_modes(state);
  RunLines common;
  common.model = this;
  common.state = &state;
  common.modes = &modes;
  common.zeta = damping(state, modes, common.owner);
  if (derivatives) {
    for (std::size_t j = 0; j < state.factor.size(); ++j) {
      common.K_part.emplace_back(modes.phi.transpose() * base_.K_part[j] *
                                 modes.phi);
      common.M_part.emplace_back(modes.phi.transpose() * base_.M_part[j] *
                                 modes.phi);
    }
    for (std::size_t e = 0; e < state.effects.size(); ++e) {
      for (const SupportTerm& term : base_.supports) {
        const PlacedEffect& placed = state.effects[e];
        if (placed.effect->entry() == effects::Entry::Support &&
            placed.where == term.where) {
          common.support_effects.push_back(e);
          common.S.emplace_back(modes.phi.transpose() * term.S * modes.phi);
        }
      }
    }
  }
  ModelResponse out;
  const auto n = static_cast<Index>(pairs_.size());
  out.H.resize(s.size(), n);
  if (derivatives) {
    out.dH.assign(static_cast<std::size_t>(state.parameters()),
                  MatrixXcd::Zero(s.size(), n));
  }
  for (const std::vector<std::size_t>& members : by_run_) {
    RunLines lines = common;
    lines.pairs = members;
    lines.collect(pairs_[members.front()].run);
    for (Index line = 0; line < s.size(); ++line) {
      lines.respond(s(line), line, derivatives, out);
    }
  }
  Index column = static_cast<Index>(state.factor.size()) + state.zeta.size();
  for (const PlacedEffect& e : state.effects) {
    const auto first = static_cast<std::size_t>(column);
    column += static_cast<Index>(e.p.size());
    if (e.effect->entry() != effects::Entry::Measurement) continue;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (std::find(e.where.channels.begin(),
                    e.where.channels.end(),
                    pairs_[k].channel) == e.where.channels.end()) {
        continue;
      }
      const auto c = static_cast<Index>(k);
      for (Index line = 0; line < s.size(); ++line) {
        const complex<double> gain = e.effect->law(s(line), e.p, 0);
        for (std::size_t p = 0; derivatives && p < e.p.size(); ++p) {
          out.dH[first + p](line, c) =
              e.p[p] * e.effect->law_derivative(s(line), e.p, 0, p) *
              out.H(line, c);
        }
        for (std::size_t j = 0; j < out.dH.size(); ++j) {
          const bool own = j >= first && j < first + e.p.size();
          if (!own) out.dH[j](line, c) *= gain;
        }
        out.H(line, c) *= gain;
      }
    }
  }
  return out;
}

}  // namespace tapfit::updating
