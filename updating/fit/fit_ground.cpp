#include "updating/fit/fit_ground.hpp"

#include "updating/fit/mesh_error.hpp"
#include "updating/reduction/mesh_factors.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tapfit::updating {
namespace {

// Largest refined model that is solved without being asked for.
constexpr std::size_t refined_grid_limit = 12000;

}  // namespace

SolvedModel solve_model(const structure::Deck& deck,
                        const acquisition::TestBundle& bundle,
                        double high_hz,
                        const Progress& progress) {
  BaseOptions options;
  options.high_hz = high_hz;
  options.cache = user_cache();
  const MeasuredPoints points = measured_points(deck, bundle);
  options.points = points.all;
  options.driven = points.driven;
  const bool has_mesh = (!deck.shells.empty() || !deck.bars.empty()) &&
                        structure::can_refine(deck);
  options.split = has_mesh && 4 * deck.grids.size() <= refined_grid_limit;
  SolvedModel model{
      BaseBuilder(deck, bundle.uncertain, options, progress), {}, 0};
  if (options.split) {
    options.split = false;
    model.coarse.emplace(deck, bundle.uncertain, options, progress);
    model.mesh_factors = model.builder.hold_mesh_error(*model.coarse);
  }
  return model;
}

FitGround prepare_fits(const SolvedModel& model,
                       const MeasuredTest& test,
                       const Progress& progress) {
  FitGround ground;
  FitSetting setting = fit_setting(test, model.builder.is_free(), progress);
  std::ranges::copy(mesh_factor_sd(model.mesh_factors),
                    std::back_inserter(setting.uncertain_sd));
  ground.contour = setting.contour;
  ground.properties = property_names(*test.setting.bundle, *test.setting.deck);
  ground.fitter = std::make_unique<Fitter>(model.builder, std::move(setting));
  progress("comparison: base model", 0.5);
  const Fitter& fitter = *ground.fitter;
  const Target& target = fitter.target();
  Fit& base = ground.base;
  base.model = fitter.model_for({});
  base.result.state = fitter.first_state(*base.model, {});
  base.result.error = relative_error(
      target, base.model->respond(base.result.state, target.s, false).H);
  ground.floor_noise = noise_error(target);
  if (model.coarse) {
    const Fitter coarse(*model.coarse, fitter.setting());
    const Eigen::VectorXd bias = mesh_error(
        *base.model, *coarse.model_for({}), base.result.state, target);
    ground.floor_mesh = bias.norm();
    ground.fitter->set_mesh(*model.coarse, model.mesh_factors, bias);
  }
  return ground;
}

}  // namespace tapfit::updating
