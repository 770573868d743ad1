#include "updating/fit/fitter.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/effects/joint_cards.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/stiffness_loss.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/fit/fitted_form.hpp"
#include "updating/fit/typical_damping.hpp"
#include "updating/frf_model/mesh_at_state.hpp"
#include "updating/places/told_apart.hpp"
#include "updating/residual/parameter_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;

Fitter::Fitter(const BaseBuilder& builder, FitProblem problem)
    : builder_(&builder), problem_(std::move(problem)) {}

Fitter Fitter::with(FitProblem problem) const {
  Fitter other = *this;
  other.problem_ = std::move(problem);
  return other;
}

void Fitter::set_mesh(const BaseBuilder& coarser) {
  coarser_ = &coarser;
  plain_coarser_ = Fitter(coarser, problem_).model_for({});
}

const std::vector<Location>& Fitter::places(
    const effects::Effect& effect) const {
  const std::scoped_lock lock(places_->mutex);
  const auto [it, fresh] = places_->of.try_emplace(&effect);
  if (fresh) {
    if (problem_.modes && !effect.shows_in_modes()) return it->second;
    it->second = effect.places(problem_.context);
    const bool anywhere = effect.sits_at_grid() ||
                          effect.changes_stiffness() == ChangeKind::Joint;
    if (anywhere) it->second = told_apart(it->second, *problem_.context.deck);
  }
  return it->second;
}

namespace {

bool change_stiffness(const std::vector<EffectInstance>& effects) {
  return std::ranges::any_of(effects, [](const EffectInstance& e) {
    return e.effect->changes_stiffness().has_value();
  });
}

}  // namespace

std::shared_ptr<const FrfModel> Fitter::model_for(
    const std::vector<EffectInstance>& effects, BaseUse use) const {
  const std::vector<int> acted = acted_points(problem_.context, effects);
  std::vector<StiffnessChange> changes;
  for (const EffectInstance& e : effects) {
    const auto kind = e.effect->changes_stiffness();
    if (!kind) continue;
    changes.push_back(
        {*kind,
         {e.effect->name(), e.where},
         *kind == ChangeKind::Joint
             ? effects::turned_across(e.where, problem_.context)
             : problem_.context.component,
         effects::weakened_beside(e.where, *problem_.context.deck)});
  }
  auto model = std::make_shared<FrfModel>(builder_->build(acted, changes, use),
                                          problem_.context,
                                          problem_.measured,
                                          problem_.modes);
  model->set_reference(first_state(*model, effects));
  if (use == BaseUse::Fit && !change_stiffness(effects)) {
    model->set_coarser(plain_coarser_);
  }
  return model;
}

std::shared_ptr<const FrfModel> Fitter::with_coarser(
    std::shared_ptr<const FrfModel> model,
    const std::vector<EffectInstance>& effects) const {
  if (coarser_ == nullptr || model->coarser() != nullptr) return model;
  auto both = std::make_shared<FrfModel>(*model);
  both->set_coarser(Fitter(*coarser_, problem_).model_for(effects));
  return both;
}

// What the mesh does to the modes as they have become: all fits alike, so that
// none is better for that alone.
std::shared_ptr<const FrfModel> Fitter::with_mesh_at_state(
    const ModelState& state, const FrfModel& before) const {
  return with_mesh_at(
      before,
      *before.coarser(),
      state,
      problem_.uncertain_sd.size() - before.base().corrections.size());
}

// A fit on its way: where it is, on what, and how it came there.
class Fitter::Course {
 public:
  Course(const Fitter& fitter,
         std::shared_ptr<const FrfModel> model,
         ModelState start,
         const Progress& progress)
      : fitter_(&fitter),
        targets_(fitter.problem_.targets),
        model_(std::move(model)),
        progress_(&progress) {
    result_.state = std::move(start);
  }

  /// Goes on from where another ended.
  Course(const Fitter& fitter, Fit ended, const Progress& progress)
      : Course(fitter, std::move(ended.model), {}, progress) {
    result_ = std::move(ended.result);
    history_ = std::move(result_.history);
  }

  /// The lines before those that count, widest first.
  void approach(const MinimiseOptions& options) {
    for (std::size_t k = 0; k + 1 < targets_.size(); ++k) {
      go_on(k, options);
      take_damping(stands_out());
    }
  }

  /// The lines that count, with the mesh's error and the damping of higher
  /// modes as they are there: again until nothing moves any more.
  void arrive(const MinimiseOptions& options, int rounds) {
    const std::size_t last = targets_.size() - 1;
    model_ = fitter_->with_coarser(std::move(model_), result_.state.effects);
    bool there = false;
    for (int round = 0; round < rounds; ++round) {
      if (round > 0 && !take_damping(stands_out()) && there) break;
      const Eigen::VectorXd from = pack(result_.state);
      if (model_->coarser() == nullptr) {
        go_on(last, options);
      } else if (!with_mesh(options)) {
        break;
      }
      if (is_enough(*progress_)) break;
      there = is_there(from);
    }
  }

  /// The lines that count as they are, with no end in view.
  void begin_last(const MinimiseOptions& options) {
    go_on(targets_.size() - 1, options);
  }

  /// The lines that count once more from another state, kept where it is
  /// better.
  void try_from(ModelState state, const MinimiseOptions& options) {
    const UpdateResult found = result_;
    result_.state = std::move(state);
    go_on(targets_.size() - 1, options);
    if (result_.objective > found.objective) result_ = found;
  }

  /// The ratio of the modes beyond the band as near as it can be told. False
  /// where it stays as it was.
  bool settle_damping(const MinimiseOptions& options, int rounds) {
    bool moved = false;
    for (int round = 0; round < rounds; ++round) {
      if (!take_damping(settled_damping)) break;
      go_on(targets_.size() - 1, options);
      moved = true;
    }
    return moved;
  }

  [[nodiscard]] const UpdateResult& result() const { return result_; }
  [[nodiscard]] const FrfModel& model() const { return *model_; }

  [[nodiscard]] Fit finished() && {
    Fit fit;
    fit.result = std::move(result_);
    fit.result.history = std::move(history_);
    fit.effects = fit.result.state.effects;
    fit.model = std::move(model_);
    take_form(fit);
    return fit;
  }

 private:
  // Of a parameter's standard deviation.
  static constexpr double settled_step = 0.05;
  // Of the ratio of the modes beyond the band: then the error stands to a
  // thousandth of it.
  static constexpr double settled_damping = 0.01;

  void take_form(Fit& fit) {
    Target& target = targets_.back();
    FittedForm form = fitted_form(
        *fit.model, fit.result, target, fitter_->problem_.form_allowance);
    fit.form = std::move(form.view);
    fit.log_likelihood = form.log_likelihood;
    target.form_bias = std::move(form.bias);
    const UpdateResult& own = fit.result;
    fit.result.covariance =
        parameter_covariance(target,
                             own.jacobian,
                             own.residual,
                             own.prior.sd,
                             known_slopes(own.prior, pack(own.state)));
  }

  void go_on(std::size_t stage, const MinimiseOptions& options) {
    const ModelState state = result_.state;
    // How often the last lines are gone over is not known.
    const double from = done_;
    done_ += 0.5 * (1.0 - done_);
    result_ = update(*model_,
                     targets_[stage],
                     state,
                     fitter_->prior_for(*model_, state),
                     options,
                     observed_part(*progress_, from, done_));
    // It starts where the last step of the stage ended.
    const bool again =
        !history_.empty() && history_.back().stage == static_cast<int>(stage);
    for (std::size_t k = again ? 1 : 0; k < result_.history.size(); ++k) {
      history_.push_back(std::move(result_.history[k]));
      history_.back().stage = static_cast<int>(stage);
    }
  }

  // With the mesh's error as it is at this state; false where that ends above
  // what it began from: then it ends as it was.
  bool with_mesh(const MinimiseOptions& options) {
    const std::size_t last = targets_.size() - 1;
    const ModelState from = result_.state;
    const std::shared_ptr<const FrfModel> held = model_;
    const double known = relative_error(
        targets_[last], held->respond(from, targets_[last].s, false).H);
    const std::size_t steps = history_.size();
    model_ = fitter_->with_mesh_at_state(from, *held);
    go_on(last, options);
    if (result_.error <= known) return true;
    model_ = held;
    history_.resize(steps);
    result_.state = from;
    go_on(last, options);
    return false;
  }

  // Whether the modes beyond the band have another ratio than was assumed, by
  // more than that part of it.
  bool take_damping(double noticed) {
    ModelState& state = result_.state;
    const double now = typical_damping(result_);
    if (std::abs(std::log(now / state.zeta_other)) < noticed) return false;
    state.zeta_other = now;
    return true;
  }

  // Within the scatter of ratios there is no telling.
  [[nodiscard]] double stands_out() const {
    return 0.2 * fitter_->problem_.damping_spread;
  }

  [[nodiscard]] bool is_there(const Eigen::VectorXd& from) const {
    const Eigen::VectorXd sd = result_.covariance.diagonal().cwiseSqrt();
    const Eigen::VectorXd moved = (pack(result_.state) - from).cwiseAbs();
    return (moved.array() <= settled_step * sd.array()).all();
  }

  const Fitter* fitter_;
  std::vector<Target> targets_;
  std::shared_ptr<const FrfModel> model_;
  const Progress* progress_;
  double done_ = 0.0;
  UpdateResult result_;
  std::vector<UpdateStep> history_;
};

namespace {

// Within a few hundredths of a standard error of the best.
constexpr MinimiseOptions exact{30, 1e-6, 1e-3};
constexpr int rounds = 4;  // damping and number of data settle
constexpr MinimiseOptions wide{10, 1e-3, 1e-1};
// From the wide lines' end the lines that count are a step or two away.
constexpr MinimiseOptions brief{2, 1e-3, 1e-1};

}  // namespace

std::optional<Fit> Fitter::approach(const std::vector<EffectInstance>& start,
                                    std::shared_ptr<const FrfModel> model,
                                    const Progress& progress,
                                    double too_much) const {
  ModelState first = start_state(*model, start);
  Course course(*this, std::move(model), std::move(first), progress);
  course.approach(wide);
  if (course.result().error > too_much) return std::nullopt;
  course.begin_last(brief);
  return std::move(course).finished();
}

Fit Fitter::arrive(Fit approached, const Progress& progress) const {
  Course course(*this, std::move(approached), progress);
  course.arrive(exact, rounds);
  return std::move(course).finished();
}

Fit Fitter::fit(const std::vector<EffectInstance>& start,
                std::shared_ptr<const FrfModel> model,
                const Progress& progress,
                const Fit* before) const {
  ModelState first = start_state(*model, start);
  if (before != nullptr) {
    // What is small is seen only where the rest of the model is right.
    const Target& seen = problem_.targets.front();
    const auto left = [&model, &seen](const ModelState& state) {
      return relative_error(seen, model->respond(state, seen.s, false).H);
    };
    ModelState fitted = start_state(*model, start, before);
    if (left(fitted) < left(first)) first = std::move(fitted);
  }
  Course course(*this, std::move(model), std::move(first), progress);
  course.approach(wide);
  course.arrive(exact, rounds);
  constexpr double rounding = 1e-6;
  if (before != nullptr &&
      course.result().error > (1.0 + rounding) * before->result.error) {
    if (auto known = continued(course.model(), start, *before)) {
      course.try_from(std::move(*known), exact);
    }
  }
  return std::move(course).finished();
}

Fit Fitter::fit_beside(const Fit& fit,
                       const std::vector<EffectInstance>& effects,
                       std::shared_ptr<const FrfModel> model,
                       const Progress& progress) const {
  ModelState first = beside(*model, effects, fit);
  Course course(*this, std::move(model), std::move(first), progress);
  course.arrive(exact, rounds);
  return std::move(course).finished();
}

Fit Fitter::settled(Fit fit, const Progress& progress) const {
  if (problem_.modes || is_enough(progress)) return fit;
  Course course(*this, fit, progress);
  if (!course.settle_damping(exact, rounds)) return fit;
  return std::move(course).finished();
}

double Fitter::held_out_error(const Fit& fit,
                              int folds,
                              const Progress& progress) const {
  const Target& whole = target();
  std::set<std::size_t> runs;
  for (std::size_t f = 0; f < whole.run.size(); ++f) {
    if (whole.use[f] > 0.0) runs.insert(whole.run[f]);
  }
  const int groups = std::min<int>(folds, static_cast<int>(runs.size()));
  if (groups < 2) return fit.result.error;
  const Prior prior = prior_for(*fit.model, fit.result.state);
  constexpr MinimiseOptions brief_refit{6, 1e-4};
  const Progress quiet{{}, progress.stop};
  std::vector<double> squared(static_cast<std::size_t>(groups));
  std::vector<double> count(squared.size());
  for_each_parallel(squared.size(), [&](std::size_t group) {
    Target training = whole;
    Target test = whole;
    std::size_t position = 0;
    for (const std::size_t run : runs) {
      const bool out = position++ % squared.size() == group;
      for (std::size_t f = 0; f < whole.run.size(); ++f) {
        if (whole.run[f] != run) continue;
        training.use[f] = out ? 0.0 : whole.use[f];
        test.use[f] = out ? whole.use[f] : 0.0;
      }
    }
    const UpdateResult refit = update(
        *fit.model, training, fit.result.state, prior, brief_refit, quiet);
    const ModelResponse response =
        fit.model->respond(refit.state, whole.s, false);
    const double error = relative_error(test, response.H);
    squared[group] = error * error * test.count();
    count[group] = test.count();
  });
  return std::sqrt(std::accumulate(squared.begin(), squared.end(), 0.0) /
                   std::accumulate(count.begin(), count.end(), 0.0));
}

}  // namespace tapfit::updating
