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

constexpr double whole = 1.0;  // of what an effect leaves

// Of the modes in the band how far the last effect, which leaves a share of
// what is there, moves their stiffness: root mean square, beside what it does
// to all of them, which the modulus may do as well.
double change_of_modes(const Fit& fit) {
  const effects::TestContext& context = fit.model->context();
  ModelState without = fit.result.state;
  without.effects.back().p.front() = whole;
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

}  // namespace

bool is_told(const Fit& fit) {
  constexpr double in_95 = 1.96;  // standard deviations
  const EffectInstance& last = fit.result.state.effects.back();
  const Eigen::Index own = fit.result.covariance.rows() - 1;
  if (last.p.size() != 1 || own < 0) return true;
  if (parameters_of(last, *fit.model).front().upper != whole) return true;
  const double sd = std::sqrt(std::max(fit.result.covariance(own, own), 0.0));
  return std::log(whole / last.p.front()) > in_95 * sd ||
         change_of_modes(fit) > middle_tau * fit.form.allowance;
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
