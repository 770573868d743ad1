#include "updating/frf_model/form_entries.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/frf_model/measurement_chain.hpp"
#include "updating/frf_model/modal_superposition.hpp"
#include "updating/frf_model/run_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

std::vector<FrfModel::Walk> FrfModel::walk_columns(
    const ModelState& state,
    const VectorXcd& s,
    const MatrixXd& candidates) const {
  if (modes_) return walk_modes(state, s, candidates);
  const ModalState shared = modal_state(state, base_modes(state));
  const MatrixXd& phi = shared.modes.phi;
  const bool same = phi.isIdentity(0.0);
  const MatrixXd of = phi.transpose() * candidates;
  const MatrixXd squares = of.cwiseAbs2().transpose();
  const MatrixXcd flexible = flexibility(shared, s);
  ModelResponse chain{
      MatrixXcd::Ones(s.size(), static_cast<Index>(pairs_.size())), {}};
  apply_chain(pairs_, shared, s, chain);
  std::vector<Walk> result;
  for (const RunResponse& lines : walks(shared)) {
    Walk walk;
    walk.pairs = lines.pairs;
    walk.recorded.resize(s.size(), static_cast<Index>(lines.pairs.size()));
    for (std::size_t k = 0; k < lines.pairs.size(); ++k) {
      walk.recorded.col(static_cast<Index>(k)) =
          chain.H.col(lines.pairs[k].frf);
    }
    walk.own.resize(s.size(), candidates.cols());
    for (Index line = 0; line < s.size(); ++line) {
      const VectorXcd g = flexible.col(line);
      VectorXcd own = squares * g;
      MatrixXcd coupled;
      if (lines.B.cols() > 0) {
        // diag(of' H* of) = diag(of' H of) - what the effects take away
        coupled = lines.coupling(
            s(line), lines.B.transpose() * (g.asDiagonal() * lines.B));
        const MatrixXcd GBc = of.transpose() * (g.asDiagonal() * lines.B);
        own -= (GBc * coupled).cwiseProduct(GBc).rowwise().sum();
      }
      walk.own.row(line) = own.transpose();
      const MatrixXcd Xo = lines.columns(g, coupled, lines.responses);
      const MatrixXcd Xi = lines.columns(g, coupled, lines.references);
      walk.Xo.push_back(same ? Xo : phi * Xo);
      walk.Xi.push_back(same ? Xi : phi * Xi);
    }
    result.push_back(std::move(walk));
  }
  return result;
}

// e_ij = phi_i' (K - omega_i omega_j M) phi_j / (omega_i omega_j)
double FrfModel::left_by_mesh(const ModelState& state,
                              const BaseModes& modes,
                              const FormEntry& entry) const {
  if (base_.corrections.empty()) return 0.0;
  const std::size_t t = part_of(state.factor.size() - base_.corrections.size());
  const auto [i, j] = entry;
  const double square = modes.omega(i) * modes.omega(j);
  const double K = modes.phi.col(i).dot(base_.K_part[t] * modes.phi.col(j));
  const double M = modes.phi.col(i).dot(base_.M_part[t] * modes.phi.col(j));
  const double beside = i == j ? 1.0 : M_SQRT2;  // see form_patterns()
  return mesh_left_over * beside * std::abs(K / square - M);
}

namespace {

// What the first modes move at each point, times their omega: lines x modes of
// one point after another.
class MotionsByPoint {
 public:
  MotionsByPoint(const VectorXd& omega, Index points, Index lines)
      : omega_(omega),
        at_(static_cast<std::size_t>(points), MatrixXcd(lines, omega.size())) {}

  /// @param X all modes x points
  void take(Index line, const MatrixXcd& X) {
    for (std::size_t p = 0; p < at_.size(); ++p) {
      const auto moved = X.col(static_cast<Index>(p)).head(omega_.size());
      at_[p].row(line) = omega_.cwiseProduct(moved).transpose();
    }
  }
  [[nodiscard]] const MatrixXcd& at(Index point) const {
    return at_[static_cast<std::size_t>(point)];
  }

 private:
  VectorXd omega_;
  std::vector<MatrixXcd> at_;
};

// What all modes have in common, as weights of their o r: each its stiffness,
// that with its order, and that of those beyond the first.
MatrixXd common_weights(const VectorXd& omega, double top, Index first) {
  constexpr double reach = 4.0;  // of the band: those that are modes, not
                                 // responses of still higher ones
  MatrixXd weights(omega.size(), 3);
  weights.col(0) = omega.cwiseAbs2();
  weights.col(1) = weights.col(0).cwiseProduct((omega / top).cwiseMin(reach));
  weights.col(2) = weights.col(1);
  weights.col(2).head(first).setZero();
  return weights;
}

// Of one pair: those of the entries, and the common ones by what they are yet
// to be scaled.
// @param o, r of its response and reference
void take_pair(const std::vector<FormEntry>& entries,
               const MatrixXcd& o,
               const MatrixXcd& r,
               const VectorXcd& scale,
               Index frf,
               std::vector<MatrixXcd>& patterns) {
  const MatrixXcd scaled = scale.asDiagonal() * o;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto [i, j] = entries[k];
    auto change = patterns[k].col(frf);
    change = scaled.col(i).cwiseProduct(r.col(j));
    if (i == j) continue;
    change += scaled.col(j).cwiseProduct(r.col(i));
    change /= M_SQRT2;
  }
  for (std::size_t k = entries.size(); k < patterns.size(); ++k) {
    patterns[k].col(frf) = patterns[k].col(frf).cwiseProduct(scale).eval();
  }
}

}  // namespace

FormPatterns FrfModel::form_patterns(const ModelState& state,
                                     const VectorXcd& s) const {
  if (modes_) return form_patterns_of_modes(state);
  constexpr double beyond = 1.3;  // of the band: modes that still show in it
  const ModalState shared = modal_state(state, base_modes(state));
  const VectorXd& w = shared.modes.omega;
  const double top = 2.0 * M_PI * context_.high_hz;
  const Index modes = (w.array() < beyond * top).count();
  const auto n = static_cast<Index>(pairs_.size());
  const std::vector<FormEntry> entries =
      form_entries(w,
                   points_.transpose() * shared.modes.phi,
                   form_below * s.imag().minCoeff(),
                   modes);
  Index seen = 0;
  for (const FormEntry& e : entries) seen = std::max(seen, e.j + 1);
  const MatrixXd common = common_weights(w, top, modes);
  std::vector<MatrixXcd> patterns(
      entries.size() + static_cast<std::size_t>(common.cols()),
      MatrixXcd::Zero(s.size(), n));
  ModelResponse chain{MatrixXcd::Ones(s.size(), n), {}};
  apply_chain(pairs_, shared, s, chain);
  const MatrixXcd flexible = flexibility(shared, s);
  for (const RunResponse& lines : walks(shared)) {
    MotionsByPoint o(w.head(seen), lines.responses.cols(), s.size());
    MotionsByPoint r(w.head(seen), lines.references.cols(), s.size());
    for (Index l = 0; l < s.size(); ++l) {
      const VectorXcd g = flexible.col(l);
      MatrixXcd coupled;
      if (lines.B.cols() > 0) {
        coupled = lines.coupling(
            s(l), lines.B.transpose() * (g.asDiagonal() * lines.B));
      }
      const MatrixXcd Xo = lines.columns(g, coupled, lines.responses);
      const MatrixXcd Xi = lines.columns(g, coupled, lines.references);
      o.take(l, Xo);
      r.take(l, Xi);
      for (Index c = 0; c < common.cols(); ++c) {
        const MatrixXcd weighted = common.col(c).asDiagonal() * Xi;
        const MatrixXcd sums = Xo.transpose() * weighted;
        auto& pattern = patterns[entries.size() + static_cast<std::size_t>(c)];
        for (const WalkedPair& p : lines.pairs) {
          pattern(l, p.frf) = sums(p.response, p.reference);
        }
      }
    }
    for (const WalkedPair& p : lines.pairs) {
      const VectorXcd scale =
          -s.cwiseProduct(s).cwiseProduct(chain.H.col(p.frf));
      take_pair(
          entries, o.at(p.response), r.at(p.reference), scale, p.frf, patterns);
    }
  }
  VectorXd left = VectorXd::Zero(std::ssize(patterns));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    left(static_cast<Index>(k)) = left_by_mesh(state, shared.modes, entries[k]);
  }
  return {std::move(patterns), std::move(left)};
}

ModelResponse FrfModel::respond(const ModelState& state,
                                const VectorXcd& s,
                                bool derivatives) const {
  ModalState shared = modal_state(state, base_modes(state));
  return respond(shared, s, derivatives);
}

MatrixXcd FrfModel::respond_through(const BaseModes& modes,
                                    const ModelState& state,
                                    const VectorXcd& s) const {
  ModalState shared = modal_state(state, modes);
  return respond(shared, s, false).H;
}

ModelResponse FrfModel::respond(ModalState& shared,
                                const VectorXcd& s,
                                bool derivatives) const {
  if (modes_) return respond_modes(shared, derivatives);
  const ModelState& state = *shared.state;
  if (derivatives) find_turning(shared, s.cwiseAbs().maxCoeff());
  ModelResponse out;
  const auto n = static_cast<Index>(pairs_.size());
  out.H.resize(s.size(), n);
  if (derivatives) {
    out.dH.assign(static_cast<std::size_t>(state.parameters()),
                  MatrixXcd::Zero(s.size(), n));
  }
  const std::vector<RunResponse> all = walks(shared);
  const MatrixXcd flexible = flexibility(shared, s);
  for (const RunResponse& lines : all) {
    superpose_modes(lines, s, flexible, out);
  }
  apply_chain(pairs_, shared, s, out);
  return out;
}

// Of an effect in the channels: the structure moves as without it.
std::vector<MatrixXcd> FrfModel::recorded_at_sizes(
    const ModelState& state,
    const std::vector<std::vector<double>>& sizes,
    const VectorXcd& s) const {
  ModelState without = state;
  without.effects.pop_back();
  const MatrixXcd H = respond(without, s, false).H;
  EffectInstance last = state.effects.back();
  std::vector<MatrixXcd> result;
  for (const std::vector<double>& size : sizes) {
    last.p = size;
    ModelResponse out{H, {}};
    apply_channel_effect(pairs_, last, 0, s, out);
    result.push_back(std::move(out.H));
  }
  return result;
}

std::vector<MatrixXcd> FrfModel::respond_at_sizes(
    const ModelState& state,
    const std::vector<std::vector<double>>& sizes,
    const VectorXcd& s) const {
  const EffectInstance& last = state.effects.back();
  if (is_passed_on(context_, state.effects)) {
    return recorded_at_sizes(state, sizes, s);
  }
  const bool changes_base = last.effect->changes_stiffness().has_value();
  BaseModes bare;
  if (!changes_base) bare = base_modes(state);
  ModelState sized = state;
  std::vector<MatrixXcd> result;
  for (const std::vector<double>& size : sizes) {
    sized.effects.back().p = size;
    ModalState shared =
        modal_state(sized, changes_base ? base_modes(sized) : bare);
    result.push_back(respond(shared, s, false).H);
  }
  return result;
}

}  // namespace tapfit::updating
