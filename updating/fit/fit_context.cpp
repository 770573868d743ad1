#include "updating/fit/fit_context.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/corrections/corrections.hpp"
#include "updating/measurement/bundle_modes.hpp"
#include "updating/measurement/mode_choices.hpp"
#include "updating/residual/mesh_error.hpp"
#include "updating/structure/checks/unit_checks.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tapfit::updating {
namespace {

// Those of shapes need no residual vectors: one keeps the base small.
MeasuredPoints tested_points(const structure::Deck& deck,
                             const acquisition::TestBundle& bundle) {
  if (!bundle.modes) return measured_points(deck, bundle);
  MeasuredPoints points;
  for (const Dof& dof : read_bundle_modes(bundle).dofs) {
    points.all.push_back(6 * static_cast<int>(deck.grid_index(dof.node)) +
                         dof.component - 1);
  }
  std::ranges::sort(points.all);
  if (!points.all.empty()) points.driven = {points.all.front()};
  return points;
}

// Pairs by hand, with the deck's modes. Without a partner: left out.
// @return the measured modes that stay
std::vector<Eigen::Index> take_pairs(const std::vector<PairByHand>& by_hand,
                                     Eigen::Index model_modes,
                                     ModalData& data) {
  std::vector<bool> stays(static_cast<std::size_t>(data.modes()), true);
  std::vector<std::string> said_by_comparison;
  for (const modal::Pair& pair : pairs_by_index(
           by_hand, data.frequency_hz, model_modes, said_by_comparison)) {
    if (pair.model >= 0) data.fixed.emplace_back(pair.measured, pair.model);
    stays[static_cast<std::size_t>(pair.measured)] = pair.model >= 0;
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index r = 0; r < data.modes(); ++r) {
    if (stays[static_cast<std::size_t>(r)]) kept.push_back(r);
  }
  return kept;
}

std::vector<Eigen::Index> without(const std::vector<Eigen::Index>& foreign,
                                  Eigen::Index all) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index r = 0; r < all; ++r) {
    if (std::ranges::count(foreign, r) == 0) kept.push_back(r);
  }
  return kept;
}

std::string units_in_doubt(const FitProblem& problem) {
  const std::vector<std::string> all =
      structure::unit_warnings(*problem.context.deck);
  return all.empty() ? "" : all.front();
}

// A mode of the model for each that was measured.
void check_modes(const FitProblem& problem, const FrfModel& model) {
  const Eigen::Index measured = problem.modes->modes();
  const Eigen::Index own = model.modes_at_points().first.size();
  if (own >= measured) return;
  const std::string doubt = units_in_doubt(problem);
  throw InputError(
      fmt::format("there are more measured modes ({}) than the model has ({})",
                  measured,
                  own),
      problem.context.bundle->modes->file.filename().string(),
      doubt.empty() ? "leave those out that the model cannot have, by band_hz"
                    : "put the deck right first: " + doubt);
}

// Leaves out what the base model has no mode like.
void settle_modes(const BaseBuilder& builder,
                  const std::vector<PairByHand>& by_hand,
                  FitProblem& problem) {
  const std::string file =
      problem.context.bundle->modes->file.filename().string();
  const FrfModel model(
      builder.build({}, {}), problem.context, problem.measured, problem.modes);
  const auto [omega, at_points] = model.modes_at_points();
  ModalData data = *problem.modes;
  data = data.only(take_pairs(by_hand, omega.size(), data));
  const std::vector<Eigen::Index> foreign =
      foreign_modes(data, omega, at_points);
  for (const Eigen::Index r : foreign) {
    problem.measured.statements.push_back(fmt::format(
        "the measured mode at {:.6g} Hz is left out of fits: the model has no "
        "mode whose shape is alike",
        data.frequency_hz(r)));
  }
  const std::vector<Eigen::Index> own = without(foreign, data.modes());
  // A deck with a number that no structure has is put right in the diagnosis.
  if (own.empty() && units_in_doubt(problem).empty()) {
    throw InputError("no measured shape is like one of the model's",
                     file,
                     "check the points' grids and directions");
  }
  if (!own.empty()) data = data.only(own);
  problem.modes = std::make_shared<const ModalData>(std::move(data));
  problem.targets = {make_target(*problem.modes)};
}

// Largest deck whose elements are split without being asked for: once split it
// has four times as many grids.
constexpr std::size_t most_grids_to_split = 3000;

// Why what the mesh leaves cannot be told; empty where it can, or where there
// is no mesh.
std::string why_not_split(const structure::Deck& deck) {
  if (deck.shells.empty() && deck.bars.empty() && deck.solids.empty()) {
    return "";
  }
  if (!structure::can_refine(deck)) {
    return "solids and quadratic shells are not split";
  }
  if (deck.grids.size() <= most_grids_to_split) return "";
  return fmt::format("elements are split up to {} grids, and the model has {}",
                     most_grids_to_split,
                     deck.grids.size());
}

}  // namespace

SolvedModel solve_model(const structure::Deck& deck,
                        const acquisition::TestBundle& bundle,
                        double high_hz,
                        const Progress& progress) {
  BaseOptions options;
  options.high_hz = high_hz;
  options.cache = user_cache();
  const MeasuredPoints points = tested_points(deck, bundle);
  options.points = points.all;
  options.driven = points.driven;
  const std::string unsplit = why_not_split(deck);
  const bool has_mesh = !deck.shells.empty() || !deck.bars.empty();
  options.split = has_mesh && unsplit.empty();
  options.on_two_meshes = options.split;
  SolvedModel model{
      BaseBuilder(deck, bundle.uncertain, options, progress), {}, {}, unsplit};
  if (options.split) {
    options.split = false;
    model.coarse.emplace(deck, bundle.uncertain, options, progress);
    model.corrections = model.builder.hold_corrections(*model.coarse, progress);
  }
  return model;
}

std::string mesh_warning(const SolvedModel& model) {
  if (model.why_not_split.empty()) return "";
  return fmt::format(
      "what the mesh leaves is not known and not in the floor ({}): a deck of "
      "a finer mesh would tell",
      model.why_not_split);
}

FitContext prepare_fits(const SolvedModel& model,
                        const MeasuredTest& test,
                        const Progress& progress) {
  FitContext ground;
  FitProblem problem = fit_problem(test, model.builder, progress);
  problem.corrections = model.corrections;
  std::ranges::transform(model.corrections,
                         std::back_inserter(problem.uncertain_sd),
                         &Correction::sd);
  if (const std::string said = mesh_warning(model); !said.empty()) {
    problem.measured.statements.push_back(said);
  }
  ground.contour = problem.contour;
  ground.properties = property_names(*test.context.bundle, *test.context.deck);
  if (problem.modes) {
    settle_modes(model.builder, test.measurement.choices().pairs, problem);
  }
  ground.fitter = std::make_unique<Fitter>(model.builder, std::move(problem));
  progress("comparison: base model", 0.5);
  const Fitter& fitter = *ground.fitter;
  const Target& target = fitter.target();
  Fit& base = ground.base;
  base.model = fitter.model_for({});
  if (fitter.problem().modes) check_modes(fitter.problem(), *base.model);
  base.result.state = fitter.first_state(*base.model, {});
  base.result.error = relative_error(
      target, base.model->respond(base.result.state, target.s, false).H);
  ground.floor_noise = noise_error(target);
  if (model.coarse) {
    const Fitter coarse(*model.coarse, fitter.problem());
    ground.floor_mesh = mesh_error(
        *base.model, *coarse.model_for({}), base.result.state, target);
    ground.fitter->set_mesh(*model.coarse);
  }
  return ground;
}

}  // namespace tapfit::updating
