#include "updating/prediction/damping_with.hpp"

#include "updating/frf_model/test_as_done.hpp"
#include "updating/structure/elements/dashpots.hpp"

namespace tapfit::updating {
namespace {

double of_effects(const FrfModel& model,
                  const ModelState& state,
                  const Eigen::VectorXd& phi,
                  double omega,
                  const std::vector<std::size_t>& runs) {
  const TestAsDone done = test_as_done(model.context(), state.effects);
  double lost = 0.0;
  for (const EffectInstance& placed : state.effects) {
    if (placed.effect->entry() != effects::Entry::LowRank) continue;
    for (const std::size_t run : runs) {
      for (const effects::InterfaceDof& dof :
           placed.effect->interface_dofs(placed.where, done.context, run)) {
        const double b = model.row(dof).dot(phi);
        const double z =
            placed.effect->law({0.0, omega}, placed.p, dof.group).imag();
        lost += dof.weight * z * b * b / static_cast<double>(runs.size());
      }
    }
  }
  return lost;
}

double of_deck(const FrfModel& model, const Eigen::VectorXd& phi) {
  const ReducedBase& base = model.base();
  const Eigen::MatrixXd dampers = structure::damping_factor(
      *model.context().deck, base.size(), [&base](int dof) {
        return base.rows.row(dof);
      });
  if (dampers.cols() == 0) return 0.0;
  return (dampers.transpose() * phi).squaredNorm();
}

}  // namespace

double added_damping(const FrfModel& model,
                     const ModelState& state,
                     const Eigen::VectorXd& phi,
                     double omega,
                     const std::vector<std::size_t>& runs) {
  const double lost =
      of_effects(model, state, phi, omega, runs) + omega * of_deck(model, phi);
  return lost / (2.0 * omega * omega);
}

}  // namespace tapfit::updating
