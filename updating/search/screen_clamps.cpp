#include "updating/search/screen_clamps.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/places/held_support.hpp"
#include "updating/search/worth_fitting.hpp"

#include <utility>

namespace tapfit::updating {
namespace {

// FRFs of the fit with one more support, its damping that of the modes so far.
Eigen::MatrixXcd frfs_held(const Fit& current,
                           const PlacedEffect& support,
                           const Fitter& fitter,
                           const Eigen::VectorXcd& s) {
  std::vector<PlacedEffect> effects = current.effects;
  effects.push_back(support);
  const auto model = fitter.coarse_model_for(effects);
  ModelState state = fitter.first_state(*model, effects);
  state.factor = current.result.state.factor;
  state.zeta_other = current.result.state.zeta_other;
  state.zeta.setConstant(state.zeta_other);
  return model->respond(state, s, false).H;
}

}  // namespace

std::vector<Screened> screen_clamps(const Fit& current,
                                    const Fitter& fitter,
                                    const Target& target,
                                    const MisfitScan& misfit,
                                    const Eigen::MatrixXcd& now) {
  std::vector<Screened> result;
  for (const effects::Effect* effect : effects::catalogue()) {
    if (effect->changes_stiffness() != ChangeKind::Support) continue;
    for (const Where& where : fitter.places(*effect)) {
      PlacedEffect support{effect, where, {}};
      if (!is_held(where) || is_present(current, support)) continue;
      result.push_back({std::move(support)});
    }
  }
  for_each_parallel(result.size(), [&](std::size_t k) {
    const Eigen::MatrixXcd H =
        frfs_held(current, result[k].placed, fitter, target.s);
    const Eigen::MatrixXd change = misfit.change(H - now);
    result[k].error = misfit.errors(change)(0);
  });
  return result;
}

}  // namespace tapfit::updating
