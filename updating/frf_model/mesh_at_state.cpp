#include "updating/frf_model/mesh_at_state.hpp"

#include "acquisition/foundation/constants.hpp"
#include "updating/corrections/mesh_shift.hpp"

#include <Eigen/QR>

#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Beyond this many times the band the vectors of a base are no modes.
constexpr double reach = 2.5;

MeshModes seen_by_grids(const FrfModel& model, const BaseModes& modes) {
  const double top = two_pi * reach * model.context().high_hz;
  const Index count = (modes.omega.array() < top).count();
  return {model.base().rows * modes.phi.leftCols(count),
          modes.omega.head(count) / two_pi};
}

}  // namespace

std::shared_ptr<const FrfModel> with_mesh_at(const FrfModel& model,
                                             const FrfModel& coarser,
                                             const ModelState& state,
                                             std::size_t factor) {
  ModelState unscaled = state;
  for (std::size_t k = factor; k < unscaled.factor.size(); ++k) {
    unscaled.factor[k] = 1.0;
  }
  const BaseModes modes = model.base_modes(unscaled);
  const MeshModes finer = seen_by_grids(model, modes);
  const MeshShift shift =
      mesh_shift(finer, seen_by_grids(coarser, coarser.base_modes(unscaled)));
  // phi' M phi = I: what is diagonal in the modes is M phi times it.
  const MatrixXd turned = modes.phi.transpose();
  const MatrixXd M_phi = turned.householderQr().solve(
      MatrixXd::Identity(turned.rows(), finer.hz.size()));
  auto result = std::make_shared<FrfModel>(model);
  result->set_part(factor,
                   M_phi * shift.K * M_phi.transpose(),
                   M_phi * shift.M * M_phi.transpose());
  return result;
}

}  // namespace tapfit::updating
