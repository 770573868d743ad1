#include "updating/diagnosis/worth.hpp"

#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/frf_model/form_entries.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::updating {

const double very_strong = std::log(150.0);
const double at_floor = 1.3;
const double clear_of_floor = 3.0;

bool Worth::earned() const {
  return gain > very_strong && with_it < share * held_out;
}

bool has_other_runs(const Target& target) {
  std::set<std::size_t> runs;
  for (std::size_t f = 0; f < target.run.size(); ++f) {
    if (target.use[f] > 0.0) runs.insert(target.run[f]);
  }
  return runs.size() > 1;
}

namespace {

// A share is told from all of it, a stiffness from any larger one, in these
// many deviations of its logarithm or of its inverse.
constexpr double in_95 = 1.96;

bool leaves_share(const effects::Effect& effect) {
  return effect.changes_stiffness() == ChangeKind::Elements;
}

// What decks are wrong by in form, too: clamps, joints, elements.
bool gives_way(const effects::Effect& effect) {
  const auto kind = effect.changes_stiffness();
  return kind && *kind != ChangeKind::Preload;
}

// As stiff as it may be, as good as not there.
EffectInstance stiffest(EffectInstance effect, const FrfModel& model) {
  const auto specs = parameters_of(effect, model);
  for (std::size_t j = 0; j < specs.size(); ++j) effect.p[j] = specs[j].upper;
  return effect;
}

// Of the modes in the band how far an effect moves their stiffness: root mean
// square, beside what it does to all of them, which the modulus may do as well.
double change_of_modes(const Fit& fit, std::size_t k) {
  const effects::TestContext& context = fit.model->context();
  ModelState without = fit.result.state;
  without.effects[k] = stiffest(without.effects[k], *fit.model);
  const Eigen::VectorXd with_it = fit.model->full_modes(fit.result.state).omega;
  const Eigen::VectorXd omega = fit.model->full_modes(without).omega;
  const double low = 2.0 * std::numbers::pi * form_below * context.low_hz;
  const double high = 2.0 * std::numbers::pi * context.high_hz;
  const Eigen::Index first = (omega.array() <= low).count();
  const Eigen::Index count =
      std::min((omega.array() < high).count(), with_it.size()) - first;
  if (count < 1) return 0.0;
  const Eigen::ArrayXd change = 2.0 * (with_it.segment(first, count).array() /
                                       omega.segment(first, count).array())
                                          .log();
  return std::sqrt((change - change.mean()).square().mean());
}

// Grids of the elements for which a test holds.
std::set<int> grids_of(const structure::Deck& deck, const auto& holds) {
  std::set<int> grids;
  const auto take = [&](const auto& all) {
    for (const auto& element : all) {
      if (!holds(element)) continue;
      grids.insert(element.grids.begin(), element.grids.end());
    }
  };
  take(deck.shells);
  take(deck.bars);
  take(deck.rods);
  take(deck.solids);
  return grids;
}

std::set<int> grids_at(const Location& where, const structure::Deck& deck) {
  const std::set<int> elements(where.elements.begin(), where.elements.end());
  std::set<int> grids = grids_of(
      deck, [&](const auto& element) { return elements.contains(element.id); });
  grids.insert(where.nodes.begin(), where.nodes.end());
  return grids;
}

// With those that an element joins to them.
std::set<int> grids_around(const std::set<int>& grids,
                           const structure::Deck& deck) {
  return grids_of(deck, [&](const auto& element) {
    return std::ranges::any_of(element.grids,
                               [&](int id) { return grids.contains(id); });
  });
}

bool any_size_is_told(const Fit& fit, std::size_t k) {
  const ModelState& state = fit.result.state;
  Eigen::Index at =
      static_cast<Eigen::Index>(state.factor.size()) + state.zeta.size();
  for (std::size_t e = 0; e < k; ++e) at += std::ssize(state.effects[e].p);
  const Eigen::MatrixXd& covariance = fit.result.covariance;
  const EffectInstance& own = state.effects[k];
  for (const double p : own.p) {
    if (at >= covariance.rows()) return true;
    const double sd = std::sqrt(std::max(covariance(at, at), 0.0));
    const double away = leaves_share(*own.effect) ? -std::log(p) : 1.0;
    if (away > in_95 * sd) return true;
    ++at;
  }
  return false;
}

}  // namespace

bool is_told_by_size(const Fit& fit, std::size_t k) {
  const EffectInstance& own = fit.result.state.effects[k];
  return !gives_way(*own.effect) || own.p.empty() || any_size_is_told(fit, k);
}

bool is_told(const Fit& fit, std::size_t k) {
  return is_told_by_size(fit, k) ||
         change_of_modes(fit, k) > middle_tau * fit.form.allowance;
}

bool give_way_together(const EffectInstance& one,
                       const EffectInstance& other,
                       const structure::Deck& deck) {
  if (!gives_way(*one.effect) || !gives_way(*other.effect)) return false;
  const std::set<int> grids = grids_around(grids_at(one.where, deck), deck);
  return std::ranges::any_of(grids_at(other.where, deck),
                             [&](int id) { return grids.contains(id); });
}

double told_floor(const Fit& fit,
                  const Target& target,
                  const DiagnoseOptions& options) {
  return std::hypot(options.floor,
                    form_share(fit, target, options.floor_noise).error);
}

Floor floor_of(const Fit& fit,
               const Target& target,
               const DiagnoseOptions& options) {
  const FormShare form = form_share(fit, target, options.floor_noise);
  return {std::hypot(options.floor, form.usual), options.floor_noise};
}

bool is_at_floor(double error, const Floor& floor) {
  return error <= at_floor * floor.whole;
}

bool may_hide_effect(double error, const Floor& floor) {
  return is_at_floor(error, floor) && error > clear_of_floor * floor.noise;
}

double explained_error(const Floor& floor) {
  return std::min(at_floor * floor.whole, clear_of_floor * floor.noise);
}

bool is_explained(double error, const Floor& floor) {
  return error <= explained_error(floor);
}

bool is_unexplained(double error, double floor, double base, bool effects) {
  // FRFs of nothing at all have an error of 1: a base that is worse, for its
  // scale, lends no explanation to what is left.
  constexpr double nothing = 1.0;
  constexpr double part = 0.1;
  const double much = effects ? part * std::min(base, nothing) : 0.0;
  return error > std::max(clear_of_floor * floor, much);
}

}  // namespace tapfit::updating
