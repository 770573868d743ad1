#include "updating/session.hpp"

#include "acquisition/channel_names.hpp"
#include "acquisition/input_error.hpp"
#include "modal/sensor_shifts.hpp"
#include "signal/uff58.hpp"
#include "updating/compare.hpp"
#include "updating/diagnose.hpp"
#include "updating/effect_stack.hpp"
#include "updating/effects/catalogue.hpp"
#include "updating/estimates.hpp"
#include "updating/fit_setting.hpp"
#include "updating/fitter.hpp"
#include "updating/plain_fit.hpp"
#include "updating/reduced_base.hpp"
#include "updating/signature.hpp"
#include "updating/slow_poles.hpp"
#include "updating/test_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// Largest refined model that is solved without being asked for.
constexpr std::size_t refined_grid_limit = 12000;

// Of ln f, f the mesh's factor (hold_mesh_error): the limit of fine meshes is
// at 4/3 where convergence is quadratic, at 2 where it is linear.
constexpr double mesh_sd = 0.5;

}  // namespace

struct Session::Impl {
  acquisition::TestBundle bundle;
  std::optional<structure::Deck> deck;
  std::optional<std::vector<acquisition::Recording>> recordings;
  std::optional<acquisition::HitSet> hits;
  std::optional<signal::FrfSet> frfs;
  Eigen::VectorXcd ringing_poles;  // modes that outlast the block
  std::optional<modal::ModeSet> modes;

  std::optional<BaseBuilder> builder;
  std::optional<BaseBuilder> coarse_builder;
  std::unique_ptr<Fitter> fitter;
  std::string contour;
  std::vector<PropertyName> properties;
  double floor_noise = 0.0;
  double floor_mesh = 0.0;

  std::vector<OverruledHit> overruled;
  std::optional<EffectStack> stack;
  std::vector<AddedEffect> waiting;  // to be in the stack, once there is one
  UpdateChoice choice;
  std::optional<PlainTask> plain;  // where the choice is a plain one
  std::optional<Comparison> base_comparison;
  std::optional<Comparison> comparison;
  std::optional<Diagnosis> diagnosis;
  std::vector<Rung> ladder;

  void drop_from_frfs();
  void drop_current();
  void overrule_hits();
  void stack_waiting(const Progress& progress);
  void prepare_fit(Session& session, const Progress& progress);
  [[nodiscard]] Fit fit_now(const std::vector<PlacedEffect>& effects,
                            const Progress& progress);
  [[nodiscard]] Comparison compare_now(const Fit& fit) const;
  [[nodiscard]] StackFit stack_fit();
  [[nodiscard]] const Fit& current() const { return stack->fits().back(); }
  [[nodiscard]] effects::Setting setting() const;
  [[nodiscard]] std::array<double, 2> band() const;
};

Session::Session(const std::filesystem::path& bundle)
    : impl_(std::make_unique<Impl>()) {
  impl_->bundle = acquisition::read_test_bundle(bundle);
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const acquisition::TestBundle& Session::bundle() const { return impl_->bundle; }
bool Session::has_model() const {
  return impl_->bundle.deck || impl_->bundle.matrices;
}
bool Session::has_recordings() const { return impl_->recordings.has_value(); }
bool Session::has_hits() const { return impl_->hits.has_value(); }
bool Session::has_frfs() const { return impl_->frfs.has_value(); }
bool Session::has_modes() const { return impl_->modes.has_value(); }
bool Session::has_comparison() const { return impl_->comparison.has_value(); }
bool Session::has_diagnosis() const { return impl_->diagnosis.has_value(); }

const structure::Deck& Session::deck(const Progress& progress) {
  if (impl_->deck) return *impl_->deck;
  progress("model: reading", 0.0);
  impl_->deck = read_test_model(impl_->bundle);
  return *impl_->deck;
}

const std::vector<acquisition::Recording>& Session::recordings(
    const Progress& progress) {
  if (!impl_->recordings && impl_->bundle.frfs) {
    throw InputError("the test consists of ready FRFs: it has no recordings",
                     (impl_->bundle.folder / "test.json").string(),
                     "FRFs and modes can be had; for hits, comparison and "
                     "diagnosis give \"runs\"");
  }
  if (!impl_->recordings) {
    progress("recordings: reading", 0.0);
    impl_->recordings = acquisition::read_recordings(impl_->bundle);
  }
  return *impl_->recordings;
}

const acquisition::HitSet& Session::hits(const Progress& progress) {
  if (!impl_->hits) {
    const auto& all = recordings(progress);
    progress("hits: finding", 0.0);
    acquisition::HitOptions options;
    options.trigger_percent = impl_->bundle.trigger_percent;
    options.pre_trigger_s = impl_->bundle.pre_trigger_s;
    options.block_s = impl_->bundle.block_s;
    impl_->hits = acquisition::find_hits(impl_->bundle, all, options);
    impl_->overrule_hits();
  }
  return *impl_->hits;
}

const signal::FrfSet& Session::frfs(const Progress& progress) {
  if (!impl_->frfs && impl_->bundle.frfs) {
    progress("FRFs: reading", 0.0);
    impl_->frfs = signal::read_frfs_uff(*impl_->bundle.frfs).set;
  }
  if (!impl_->frfs) {
    const auto& all = recordings(progress);
    const auto& found = hits(progress);
    signal::FrfOptions options;
    impl_->frfs =
        signal::estimate_frfs(impl_->bundle, all, found, options, progress);
    // A mode that still rings when the next hit comes is known only once the
    // modes are: FRFs, modes, and FRFs again without the ringing.
    if (impl_->bundle.band_hz && several_hits(found)) {
      impl_->ringing_poles =
          slow_poles(modal::identify_modes(*impl_->frfs, {}, progress), found);
    }
    if (impl_->ringing_poles.size() > 0) {
      options.ringing_poles = impl_->ringing_poles;
      impl_->frfs =
          signal::estimate_frfs(impl_->bundle, all, found, options, progress);
    }
  }
  return *impl_->frfs;
}

const modal::ModeSet& Session::modes(const Progress& progress) {
  if (!impl_->modes) {
    impl_->modes = modal::identify_modes(frfs(progress), {}, progress);
  }
  return *impl_->modes;
}

std::array<double, 2> Session::Impl::band() const {
  if (bundle.band_hz) return *bundle.band_hz;
  const Eigen::VectorXd f = frfs->frequency_hz();
  const double rate = hits->sample_rate_hz;
  return {std::max(f.minCoeff(), 1e-3 * rate),
          std::min(f.maxCoeff(), 0.4 * rate)};
}

effects::Setting Session::Impl::setting() const {
  effects::Setting s;
  s.bundle = &bundle;
  s.deck = &*deck;
  s.mass_kg = builder->mass_kg();
  s.low_hz = band()[0];
  s.high_hz = band()[1];
  s.component = measured_component(bundle);
  return s;
}

// Model, damped lines and the base fit; all that does not depend on effects.
void Session::Impl::prepare_fit(Session& session, const Progress& progress) {
  if (fitter) return;
  const structure::Deck& the_deck = session.deck(progress);
  const acquisition::HitSet& found = session.hits(progress);
  const modal::ModeSet& identified = session.modes(progress);
  if (!builder) {
    BaseOptions options;
    options.high_hz = band()[1];
    options.cache = user_cache();
    options.points = measured_points(the_deck, bundle);
    options.split = 4 * the_deck.grids.size() <= refined_grid_limit;
    builder.emplace(the_deck, bundle.uncertain, options, progress);
    if (options.split) {
      options.split = false;
      coarse_builder.emplace(the_deck, bundle.uncertain, options, progress);
      builder->hold_mesh_error(*coarse_builder);
    }
  }
  FitSetting fit =
      fit_setting({setting(), *recordings, found, ringing_poles, identified},
                  builder->is_free(),
                  progress);
  if (coarse_builder) fit.uncertain_sd.push_back(mesh_sd);
  contour = fit.contour;
  properties = property_names(bundle, the_deck);
  fitter = std::make_unique<Fitter>(*builder, std::move(fit));
  progress("comparison: base model", 0.5);
  // The base as the deck has it: nothing fitted.
  Fit base;
  base.model = fitter->model_for({});
  base.result.state = fitter->first_state(*base.model, {});
  base.result.error = relative_error(
      fitter->target(),
      base.model->respond(base.result.state, fitter->target().s, false).H);
  stack.emplace(base, !bundle.uncertain.empty());
  floor_noise = noise_error(fitter->target());
  if (coarse_builder) {
    const Fitter coarse(*coarse_builder, fitter->setting());
    const Eigen::VectorXd bias = mesh_error(*base.model,
                                            *coarse.model_for({}),
                                            base.result.state,
                                            fitter->target());
    floor_mesh = bias.norm();
    fitter->set_mesh_bias(bias);
  }
  stack_waiting(progress);
}

StackFit Session::Impl::stack_fit() {
  return {setting(), [this](const auto& effects, const Progress& progress) {
            return fit_now(effects, progress);
          }};
}

Fit Session::Impl::fit_now(const std::vector<PlacedEffect>& effects,
                           const Progress& progress) {
  const auto model = fitter->model_for(effects);
  if (!choice.is_plain()) return fitter->fit(effects, model, progress);
  if (!plain) {
    plain = plain_task(choice,
                       {setting(), *recordings, *hits, ringing_poles, *modes},
                       {fitter->target(), contour, frfs->s.real().minCoeff()},
                       progress);
  }
  return plain_fit(*fitter, *plain, effects, model);
}

Comparison Session::Impl::compare_now(const Fit& fit) const {
  Comparison c = compare(fit, fitter->target(), *frfs, *modes);
  c.floor_noise = floor_noise;
  c.floor_mesh = floor_mesh;
  c.floor = std::hypot(floor_noise, floor_mesh);
  c.contour = contour;
  return c;
}

const Comparison& Session::base_comparison(const Progress& progress) {
  if (!impl_->base_comparison) {
    impl_->prepare_fit(*this, progress);
    impl_->base_comparison = impl_->compare_now(impl_->stack->fits().front());
  }
  return *impl_->base_comparison;
}

const Comparison& Session::comparison(const Progress& progress) {
  if (!impl_->comparison) {
    impl_->prepare_fit(*this, progress);
    impl_->comparison = impl_->compare_now(impl_->current());
  }
  return *impl_->comparison;
}

const Diagnosis& Session::diagnosis(const Progress& progress) {
  if (!impl_->diagnosis) {
    const Comparison& base = base_comparison(progress);
    DiagnoseOptions options;
    options.floor = base.floor;
    options.contour = base.contour;
    options.properties = impl_->properties;
    const auto& found = modes(progress).modes;
    options.modes_in_band = std::max(1, static_cast<int>(found.size()));
    Diagnosis d =
        diagnose(*impl_->fitter, impl_->current().effects, options, progress);
    // Nothing fitted yet: the base is the deck as it is.
    if (impl_->stack->fits().size() == 1) d.error_base = base.error;
    if (const auto& shifts = impl_->modes->shifts; modal::is_telling(shifts)) {
      d.warnings.push_back(
          modal::statement(*shifts, acquisition::channel_names(impl_->bundle)));
    }
    for (const auto& loose : mechanisms(progress)) d.warnings.push_back(loose);
    impl_->diagnosis = std::move(d);
  }
  return *impl_->diagnosis;
}

Signature Session::signature(int node, const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  static_cast<void>(impl_->deck->grid_index(node));
  // The base gains the static response at the grid looked at: without it the
  // grid's own flexibility would be taken for something missing.
  Fit current = impl_->current();
  std::vector<PlacedEffect> with_node = current.effects;
  Where where;
  where.node = node;
  with_node.push_back({&effects::find("added-mass"), where, {1.0}});
  current.model = impl_->fitter->model_for(with_node);
  return signature_at(current, impl_->fitter->target(), node, progress);
}

void Session::Impl::drop_current() {
  comparison.reset();
  diagnosis.reset();
  ladder.clear();
}

void Session::Impl::drop_from_frfs() {
  if (fitter) waiting = stack->effects();
  frfs.reset();
  ringing_poles.resize(0);
  modes.reset();
  fitter.reset();
  stack.reset();
  plain.reset();
  base_comparison.reset();
  drop_current();
}

// What was overruled before the hits were found.
void Session::Impl::overrule_hits() {
  for (const OverruledHit& overruled_hit : overruled) {
    const auto [run, hit] = overruled_hit;
    if (run < hits->runs.size() && hit < hits->runs[run].size()) {
      acquisition::overrule(hits->runs[run][hit]);
      continue;
    }
    hits.reset();
    throw InputError(
        "the saved session overrules a hit that is not there",
        fmt::format("run {}, hit {}", run + 1, hit + 1),
        "recordings or trigger have changed since: take the hit out of the "
        "session's file");
  }
}

void Session::Impl::stack_waiting(const Progress& progress) {
  try {
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      stack->add(waiting[k].ref, stack_fit(), progress);
      if (!waiting[k].on) stack->toggle(k, stack_fit(), progress);
    }
  } catch (...) {
    // As if nothing had been prepared: the next call tries again.
    fitter.reset();
    stack.reset();
    throw;
  }
}

void Session::overrule_hit(std::size_t run, std::size_t hit) {
  static_cast<void>(hits());
  acquisition::Hit& judged = impl_->hits->runs.at(run).at(hit);
  const bool before = judged.accepted;
  acquisition::overrule(judged);
  if (judged.accepted == before) return;
  // Overruled twice, it is judged as before.
  if (std::erase(impl_->overruled, OverruledHit{run, hit}) == 0) {
    impl_->overruled.push_back({run, hit});
  }
  impl_->drop_from_frfs();
}

void Session::add(const EffectRef& effect, const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  impl_->stack->add(effect, impl_->stack_fit(), progress);
  impl_->drop_current();
}

void Session::toggle(std::size_t effect, const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  impl_->stack->toggle(effect, impl_->stack_fit(), progress);
  impl_->drop_current();
}

void Session::fit_uncertain(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  impl_->stack->fit_uncertain(impl_->stack_fit(), progress);
  impl_->drop_current();
}

bool Session::undo(const Progress& progress) {
  if (!impl_->fitter && impl_->waiting.empty()) return false;
  impl_->prepare_fit(*this, progress);
  if (!impl_->stack->undo(impl_->stack_fit(), progress)) return false;
  impl_->drop_current();
  return true;
}

bool Session::redo(const Progress& progress) {
  if (!impl_->fitter || !impl_->stack->redo(impl_->stack_fit(), progress)) {
    return false;
  }
  impl_->drop_current();
  return true;
}

std::vector<AddedEffect> Session::effects() const {
  return impl_->fitter ? impl_->stack->effects() : impl_->waiting;
}

const std::vector<OverruledHit>& Session::overruled() const {
  return impl_->overruled;
}

SavedSession Session::saved(const Progress& progress) {
  SavedSession result;
  result.title = impl_->bundle.title;
  result.overruled = impl_->overruled;
  result.effects = effects();
  if (!impl_->fitter) return result;
  for (const Rung& rung : ladder(progress)) {
    const Fit& fit = impl_->stack->fits()[result.ladder.size()];
    result.ladder.push_back({rung, impl_->compare_now(fit).pairs});
  }
  return result;
}

void Session::take_up(const SavedSession& saved) {
  impl_->overruled = saved.overruled;
  impl_->waiting = saved.effects;
}

void Session::set_update(const UpdateChoice& choice) {
  impl_->choice = choice;
  impl_->plain.reset();
}

std::vector<UpdateRecord> Session::update_records(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return records_of(impl_->stack->fits(),
                    impl_->setting(),
                    impl_->properties,
                    impl_->plain ? impl_->plain->lines : impl_->contour);
}

std::vector<std::string> Session::mechanisms(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  const auto& unsplit = impl_->coarse_builder;
  return (unsplit ? unsplit : impl_->builder)->warnings();
}

const std::vector<Rung>& Session::ladder(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  if (impl_->ladder.empty()) {
    impl_->ladder = rungs_of(impl_->stack->fits(), impl_->setting());
  }
  return impl_->ladder;
}

std::vector<Estimate> Session::model_parameters(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return all_estimates(impl_->current(), impl_->properties, impl_->setting());
}

}  // namespace tapfit::updating
