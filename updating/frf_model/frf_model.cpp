#include "updating/frf_model/frf_model.hpp"

#include "updating/effects/stiffness_loss.hpp"
#include "updating/frf_model/measurement_chain.hpp"
#include "updating/frf_model/modal_superposition.hpp"
#include "updating/frf_model/run_response.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/structure/elements/dashpots.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

// Whether Woodbury's formula has anything left to add.
bool acts_beside(const EffectInstance& placed) {
  return placed.effect->entry() == effects::Entry::LowRank &&
         std::any_of(placed.p.begin(), placed.p.end(), [](double p) {
           return p != 0.0;
         });
}

}  // namespace

bool is_of(const StiffnessTerm& term, const EffectInstance& effect) {
  return effect.effect->name() == term.of.effect &&
         effect.where == term.of.where;
}

namespace {

double value_of(const StiffnessTerm& term, const ModelState& state) {
  double p = term.absent;
  for (const EffectInstance& e : state.effects) {
    // What has no size leaves nothing of it.
    if (is_of(term, e)) p = e.p.empty() ? 0.0 : e.p[term.parameter];
  }
  return p;
}

// p - included: what S is multiplied by; and the same for N.
double change_of(const StiffnessTerm& term, const ModelState& state) {
  return value_of(term, state) - term.included;
}

double thickness_change_of(const StiffnessTerm& term, const ModelState& state) {
  return effects::thickness_left(value_of(term, state)) -
         effects::thickness_left(term.included);
}

}  // namespace

FrfModel::FrfModel(ReducedBase base,
                   const effects::TestContext& context,
                   const signal::FrfSet& measured,
                   std::shared_ptr<const ModalData> modes)
    : base_(std::move(base)),
      context_(context),
      modes_(std::move(modes)),
      dashpots_(structure::damping_factor(
          *context.deck, base_.size(), [this](int dof) {
            return base_.rows.row(dof);
          })) {
  std::set<std::size_t> runs;
  std::vector<VectorXd> points;
  const auto take = [&](const Dof& dof) {
    const bool fresh =
        columns_.try_emplace(dof, static_cast<Index>(points.size())).second;
    if (fresh) points.push_back(point(dof));
  };
  for (const signal::Frf& frf : measured.frfs) {
    MeasuredPair pair;
    pair.run = frf.run;
    pair.channel = context.bundle->channels.at(frf.channel).name;
    pair.hammer = context.bundle->channels
                      .at(context.bundle->runs.at(frf.run).hammer.channel)
                      .name;
    pair.written = {frf.response, frf.reference};
    take(frf.response);
    take(frf.reference);
    runs.insert(frf.run);
    pairs_.push_back(std::move(pair));
  }
  if (modes_) {
    // What acts on the structure does so in all that was done with it.
    runs.insert(0);
    for (const Dof& dof : modes_->dofs) take(dof);
  }
  runs_.assign(runs.begin(), runs.end());
  points_.resize(base_.size(), static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    points_.col(static_cast<Index>(k)) = points[k];
  }
}

VectorXd FrfModel::point(const Dof& dof) const {
  return dof.sign * row(dof.node, dof.component).transpose();
}

Eigen::RowVectorXd FrfModel::row(int node, int component) const {
  const auto grid = static_cast<Index>(context_.deck->grid_index(node));
  return base_.rows.row(6 * grid + component - 1);
}

Eigen::RowVectorXd FrfModel::row(const effects::InterfaceDof& dof) const {
  return acted_row(dof, *context_.deck, base_);
}

BaseModes FrfModel::base_modes(const ModelState& state) const {
  std::vector<double> p;
  for (const StiffnessTerm& term : base_.terms) {
    p.push_back(value_of(term, state));
  }
  const auto [K, M] = base_.at(state.factor, p);
  // A base that holds changes of stiffness has not the coordinates of modes.
  return solve_modes(K, M, base_.terms.empty());
}

std::vector<PairEnds> FrfModel::ends(const TestAsDone& done) const {
  std::vector<PairEnds> result;
  for (const MeasuredPair& pair : pairs_) {
    result.push_back(done.sheet
                         ? ends_as_done(pair, *context_.bundle, *done.sheet)
                         : pair.written);
  }
  return result;
}

std::vector<PairEnds> FrfModel::ends(const ModelState& state) const {
  return ends(test_as_done(context_, state.effects));
}

void FrfModel::set_reference(const ModelState& state) {
  reference_phi_ = base_modes(state).phi;
}

std::size_t FrfModel::part_of(std::size_t factor) const {
  const auto own = [factor](const std::vector<int>& power) {
    return factor < power.size() && power[factor] > 0;
  };
  const auto at = std::ranges::find_if(base_.part_power, own);
  assert(at != base_.part_power.end());
  return static_cast<std::size_t>(at - base_.part_power.begin());
}

void FrfModel::set_part(std::size_t factor, MatrixXd K, MatrixXd M) {
  const std::size_t t = part_of(factor);
  base_.K_part[t] = std::move(K);
  base_.M_part[t] = std::move(M);
}

// The position in zeta of each mode's ratio, or -1. Springs and masses move
// modes past few others if any (of rank one: none), so that the modes with them
// keep the ratios of those without by order.
std::vector<int> FrfModel::damping_owners(const ModelState& state,
                                          const BaseModes& bare) const {
  const VectorXd& w = bare.omega;
  const Index count = std::min<Index>(state.zeta.size(), w.size());
  std::vector<int> owner(static_cast<std::size_t>(w.size()), -1);
  if (reference_phi_.size() == 0) {
    std::iota(owner.begin(), owner.begin() + count, 0);
    return owner;
  }
  const MatrixXd overlap =
      (reference_phi_.leftCols(count).transpose() * bare.phi).cwiseAbs();
  for (Index q = 0; q < count; ++q) {
    Index best = 0;
    overlap.row(q).maxCoeff(&best);
    owner[static_cast<std::size_t>(best)] = static_cast<int>(q);
  }
  return owner;
}

void FrfModel::set_damping(ModalState& shared) const {
  const ModelState& state = *shared.state;
  const VectorXd& w = shared.modes.omega;
  const EffectInstance* law = state.damping_law();
  DampingOfModes& damping = shared.damping;
  damping.d = damping.slope = VectorXd::Zero(w.size());
  for (Index m = 0; m < w.size(); ++m) {
    effects::ModeDamping mode;
    if (law != nullptr) {
      mode = law->mode_damping(w(m));
    } else {
      const int q = shared.owner[static_cast<std::size_t>(m)];
      const double zeta = q >= 0 ? state.zeta(q) : state.zeta_other;
      mode = {2.0 * zeta * w(m), 2.0 * zeta};
    }
    damping.d(m) = mode.c;
    if (w(m) > 0.0) damping.slope(m) = mode.slope / (2.0 * w(m));
  }
}

ModalState FrfModel::modal_state(const ModelState& state,
                                 BaseModes bare) const {
  ModalState shared;
  shared.state = &state;
  shared.done = test_as_done(context_, state.effects);
  const effects::TestContext& context = shared.done.context;
  shared.modes = std::move(bare);
  shared.owner = damping_owners(state, shared.modes);
  shared.changes = modal_modifications(state, context, runs_, base_);
  shared.beside = outside_modal_basis(state, context, runs_);
  if (!shared.changes.empty()) {
    BaseModes loaded = modes_with(shared.modes, shared.changes, state);
    shared.owner = by_order(shared.owner, shared.modes.omega, loaded.omega);
    shared.modes = std::move(loaded);
  }
  set_damping(shared);
  shared.first_zeta = state.factor.size();
  std::size_t column =
      shared.first_zeta + static_cast<std::size_t>(state.zeta.size());
  for (const EffectInstance& e : state.effects) {
    shared.first.push_back(column);
    column += e.p.size();
  }
  return shared;
}

void FrfModel::find_turning(ModalState& shared, double largest) const {
  const ModelState& state = *shared.state;
  const auto turn = [&](const MatrixXd& dK, const MatrixXd& dM) {
    return ModalDerivative(
        shared.modes.phi, shared.modes.omega, shared.damping, dK, dM, largest);
  };
  for (std::size_t j = 0; j < state.factor.size(); ++j) {
    MatrixXd dK;
    MatrixXd dM;
    const auto add = [](double c, const MatrixXd& part, MatrixXd& sum) {
      if (part.isZero(0.0)) return;
      if (sum.size() == 0) sum.setZero(part.rows(), part.cols());
      sum += c * part;
    };
    for (std::size_t t = 0; t < base_.part_power.size(); ++t) {
      const double c = part_slope(base_.part_power[t], state.factor, j);
      if (c == 0.0) continue;
      add(c, base_.K_part[t], dK);
      add(c, base_.M_part[t], dM);
    }
    for (const StiffnessTerm& term : base_.terms) {
      const MatrixXd slope = term.slope(state.factor, j);
      if (slope.size() > 0) add(change_of(term, state), slope, dK);
      const MatrixXd of_thickness = term.thickness_slope(state.factor, j);
      const MatrixXd of_mass = term.mass_slope(state.factor, j);
      const double thinner = thickness_change_of(term, state);
      if (of_thickness.size() > 0) add(thinner, of_thickness, dK);
      if (of_mass.size() > 0) add(thinner, of_mass, dM);
    }
    shared.turning.push_back({turn(dK, dM), j, state.factor[j]});
  }
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const EffectInstance& placed = state.effects[e];
    for (const StiffnessTerm& term : base_.terms) {
      if (!is_of(term, placed) || placed.p.empty()) continue;
      const double p = placed.p[term.parameter];
      MatrixXd dK = term.at(state.factor);
      MatrixXd dM;
      if (term.is_thinned()) {
        const double slope = effects::thickness_left_slope(p);
        dK += slope * term.thickness_at(state.factor);
        dM = slope * term.mass_at(state.factor);
      }
      shared.turning.push_back(
          {turn(dK, dM), shared.first[e] + term.parameter, p});
    }
  }
  for (const ModalModification& c : shared.changes) {
    shared.turning.push_back({turn(c.dK, c.dM),
                              shared.first[c.effect] + c.parameter,
                              state.effects[c.effect].p[c.parameter]});
  }
}

RunResponse FrfModel::run_lines(const ModalState& shared,
                                std::size_t run) const {
  RunResponse lines;
  lines.shared = &shared;
  const MatrixXd& phi = shared.modes.phi;
  std::vector<VectorXd> rows;
  for (Index k = 0; k < dashpots_.cols(); ++k) {
    lines.actors.push_back({});
    rows.emplace_back(phi.transpose() * dashpots_.col(k));
  }
  for (std::size_t e = 0; e < shared.beside.size(); ++e) {
    const EffectInstance& placed = shared.beside[e];
    if (!acts_beside(placed)) continue;
    for (const effects::InterfaceDof& dof : placed.effect->interface_dofs(
             placed.where, shared.done.context, run)) {
      const VectorXd b = phi.transpose() * row(dof).transpose();
      if (b.squaredNorm() < 1e-18) continue;  // held, or out of the base
      lines.actors.push_back({e, dof.group, dof.weight});
      rows.push_back(b);
    }
  }
  lines.B.resize(phi.cols(), static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    lines.B.col(static_cast<Index>(k)) = rows[k];
  }
  return lines;
}

// Runs on which the effects act alike (fixed sensors) are walked together,
// each point once.
std::vector<RunResponse> FrfModel::walks(const ModalState& shared) const {
  std::vector<RunResponse> result;
  std::vector<std::vector<std::size_t>> members;
  for (const std::size_t run : runs_) {
    RunResponse lines = run_lines(shared, run);
    std::size_t k = 0;
    while (k < result.size() &&
           !(result[k].B.cols() == lines.B.cols() && result[k].B == lines.B)) {
      ++k;
    }
    if (k == result.size()) {
      result.push_back(std::move(lines));
      members.emplace_back();
    }
    members[k].push_back(run);
  }
  const std::vector<PairEnds> all = ends(shared.done);
  const MatrixXd& phi = shared.modes.phi;
  const MatrixXd points = phi.transpose() * points_;
  const auto row_at = [&](const Dof& dof) -> VectorXd {
    const auto known = columns_.find(dof);
    if (known != columns_.end()) return points.col(known->second);
    return phi.transpose() * point(dof);  // not on the sheet
  };
  for (std::size_t k = 0; k < result.size(); ++k) {
    std::map<Dof, Index> response;
    std::map<Dof, Index> reference;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const MeasuredPair& pair = pairs_[p];
      if (std::find(members[k].begin(), members[k].end(), pair.run) ==
          members[k].end()) {
        continue;
      }
      const Index o =
          response.try_emplace(all[p].response, response.size()).first->second;
      const Index i = reference.try_emplace(all[p].reference, reference.size())
                          .first->second;
      result[k].pairs.push_back({static_cast<Index>(p), o, i});
    }
    const auto gather = [&](const std::map<Dof, Index>& columns) {
      MatrixXd at(phi.cols(), static_cast<Index>(columns.size()));
      for (const auto& [dof, to] : columns) at.col(to) = row_at(dof);
      return at;
    };
    result[k].responses = gather(response);
    result[k].references = gather(reference);
  }
  return result;
}

}  // namespace tapfit::updating
