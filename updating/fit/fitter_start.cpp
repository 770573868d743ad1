// Where fits start, and what is known before: the Fitter's states and priors.
#include "updating/fit/fitter.hpp"
#include "updating/fit/size_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;

namespace {

constexpr int start_scan = 16;

}  // namespace

std::vector<effects::ParameterSpec> parameters_of(const EffectInstance& effect,
                                                  const FrfModel& model) {
  std::vector<effects::ParameterSpec> specs =
      effect.effect->parameters(effect.where, model.context());
  for (const StiffnessTerm& term : model.base().terms) {
    if (!is_of(term, effect) || specs.empty()) continue;
    effects::ParameterSpec& spec = specs[term.parameter];
    spec.start = term.start;
    spec.lower = term.lower;
    spec.upper = term.upper;
  }
  return specs;
}

ModelState Fitter::first_state(
    const FrfModel& model, const std::vector<EffectInstance>& effects) const {
  ModelState state;
  state.factor.assign(problem_.uncertain_sd.size(), 1.0);
  state.effects = effects;
  state.zeta_other = problem_.damping_ratio;
  // Modes say nothing of what their damping does to others.
  if (state.damping_law() != nullptr || problem_.modes) return state;
  const Eigen::VectorXd omega = model.base_modes(state).omega;
  const double top = 2.0 * std::numbers::pi * problem_.context.high_hz * 1.1;
  const auto in_band = (omega.array() < top).count();
  state.zeta = Eigen::VectorXd::Constant(in_band, problem_.damping_ratio);
  return state;
}

Prior Fitter::prior_for(const FrfModel& model, const ModelState& state) const {
  const double infinite = std::numeric_limits<double>::infinity();
  const Index n = state.parameters();
  Prior prior;
  prior.mean = Eigen::VectorXd::Zero(n);
  prior.sd = Eigen::VectorXd::Constant(n, infinite);
  prior.lower = Eigen::VectorXd::Constant(n, -infinite);
  prior.upper = Eigen::VectorXd::Constant(n, infinite);
  Index k = 0;
  for (const double sd : problem_.uncertain_sd) {
    prior.sd(k) = sd;
    prior.lower(k) = -1.0;
    prior.upper(k) = 1.0;
    ++k;
  }
  k -= static_cast<Index>(problem_.corrections.size());
  for (const Correction& correction : problem_.corrections) {
    prior.mean(k) = correction.mean;
    prior.lower(k) = correction.lower;
    prior.upper(k) = correction.upper;
    ++k;
  }
  for (Index q = 0; q < state.zeta.size(); ++q, ++k) {
    prior.mean(k) = std::log(state.zeta_other);
    prior.sd(k) = problem_.damping_spread;
    prior.lower(k) = std::log(1e-5);
    prior.upper(k) = std::log(0.5);
  }
  MassLaw mass{builder_->mass_kg(),
               builder_->part_masses(),
               static_cast<Index>(state.factor.size())};
  for (const EffectInstance& e : state.effects) {
    for (const effects::ParameterSpec& spec : parameters_of(e, model)) {
      // A sensor's is not weighed with the structure.
      if (spec.name == "mass_kg" && e.where.channels.empty()) {
        mass.added.push_back(k);
      }
      prior.lower(k) = std::log(spec.lower);
      prior.upper(k) = std::log(spec.upper);
      ++k;
    }
  }
  if (problem_.weighed) {
    prior.known = [mass = std::move(mass),
                   known = *problem_.weighed](const Eigen::VectorXd& theta) {
      return mass.residual(known, theta);
    };
  }
  return prior;
}

namespace {

// Whether nothing is known of the sizes of an effect at a grid yet.
bool is_unscanned(const EffectInstance& effect, const FrfModel& model) {
  const std::vector<effects::ParameterSpec> specs =
      parameters_of(effect, model);
  return effect.effect->sits_at_grid() &&
         std::ranges::equal(
             effect.p, specs, {}, {}, &effects::ParameterSpec::start);
}

}  // namespace

// Size of the newest effect from which the fit starts: the best of a scan over
// all that it may be, everything else as it is: at a grid of several parameters
// together, if nothing is known of them, then one after the other. A resonance
// that has to move past another does not get there by following the slope.
void Fitter::scan_start(const FrfModel& model, ModelState& state) const {
  if (state.effects.empty()) return;
  std::vector<double>& p = state.effects.back().p;
  const Prior prior = prior_for(model, state);
  const Target& wide = problem_.targets.front();
  const Index first = prior.lower.size() - static_cast<Index>(p.size());
  double least = relative_error(wide, model.respond(state, wide.s, false).H);
  const auto take_best = [&](const std::vector<std::vector<double>>& sizes) {
    const auto tried = model.respond_at_sizes(state, sizes, wide.s);
    for (std::size_t t = 0; t < tried.size(); ++t) {
      const double left = relative_error(wide, tried[t]);
      if (left >= least) continue;
      least = left;
      p = sizes[t];
    }
  };
  const EffectInstance& newest = state.effects.back();
  if (p.size() > 1 && is_unscanned(newest, model)) {
    take_best(size_grid(parameters_of(newest, model)));
  }
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double low = prior.lower(first + static_cast<Index>(k));
    const double high = prior.upper(first + static_cast<Index>(k));
    std::vector<std::vector<double>> sizes(start_scan, p);
    for (int step = 0; step < start_scan; ++step) {
      sizes[static_cast<std::size_t>(step)][k] =
          std::exp(low + (high - low) * (step + 0.5) / start_scan);
    }
    take_best(sizes);
  }
}

namespace {

// Sizes that this structure may have.
std::vector<EffectInstance> in_range(std::vector<EffectInstance> effects,
                                     const FrfModel& model) {
  for (EffectInstance& e : effects) {
    const std::vector<effects::ParameterSpec> specs = parameters_of(e, model);
    for (std::size_t k = 0; k < specs.size(); ++k) {
      // A catalogue start knows nothing of this structure's own stiffness.
      const bool far = e.p[k] < specs[k].lower || e.p[k] > specs[k].upper;
      if (far) e.p[k] = specs[k].start;
    }
  }
  return effects;
}

}  // namespace

ModelState Fitter::start_state(const FrfModel& model,
                               const std::vector<EffectInstance>& start,
                               const Fit* before) const {
  ModelState state = first_state(model, in_range(start, model));
  if (before != nullptr) state.factor = before->result.state.factor;
  scan_start(model, state);
  return state;
}

// Properties and damping of a state, with other effects. It may have held
// another number of modes in the band at its start, or give way to a law for
// the damping.
ModelState Fitter::going_on(const FrfModel& model,
                            const std::vector<EffectInstance>& effects,
                            const ModelState& from) const {
  ModelState whole = first_state(model, effects);
  whole.factor = from.factor;
  whole.zeta_other = from.zeta_other;
  whole.zeta.setConstant(from.zeta_other);
  const Index known = std::min(whole.zeta.size(), from.zeta.size());
  whole.zeta.head(known) = from.zeta.head(known);
  return whole;
}

// Where a fit of the same effects ended, at other places.
ModelState Fitter::beside(const FrfModel& model,
                          const std::vector<EffectInstance>& effects,
                          const Fit& fit) const {
  ModelState state = going_on(model, effects, fit.result.state);
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const std::vector<double>& known = fit.result.state.effects[k].p;
    // A patch at the end of a plate has fewer edges.
    if (known.size() == state.effects[k].p.size()) state.effects[k].p = known;
  }
  return state;
}

std::optional<ModelState> Fitter::continued(
    const FrfModel& model,
    const std::vector<EffectInstance>& effects,
    const Fit& before) const {
  const ModelState& fewer = before.result.state;
  const std::size_t n = fewer.effects.size();
  const auto same = [](const EffectInstance& a, const EffectInstance& b) {
    return a.effect == b.effect && a.where == b.where;
  };
  const bool contains =
      n <= effects.size() &&
      fewer.factor.size() == problem_.uncertain_sd.size() &&
      std::equal(
          fewer.effects.begin(), fewer.effects.end(), effects.begin(), same);
  if (!contains) return std::nullopt;
  ModelState whole = going_on(model, effects, fewer);
  std::copy(fewer.effects.begin(), fewer.effects.end(), whole.effects.begin());
  const auto with = [&](double effects::ParameterSpec::*bound) {
    ModelState result = whole;
    for (std::size_t k = n; k < effects.size(); ++k) {
      EffectInstance& effect = result.effects[k];
      const auto specs = parameters_of(effect, model);
      for (std::size_t p = 0; p < specs.size(); ++p) {
        effect.p[p] = specs[p].*bound;
      }
    }
    return result;
  };
  const auto error = [&](const ModelState& tried) {
    return relative_error(target(), model.respond(tried, target().s, false).H);
  };
  const ModelState least = with(&effects::ParameterSpec::lower);
  const ModelState most = with(&effects::ParameterSpec::upper);
  return error(most) < error(least) ? most : least;
}

}  // namespace tapfit::updating
