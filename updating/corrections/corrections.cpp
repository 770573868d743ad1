#include "updating/corrections/corrections.hpp"

#include "updating/structure/mesh/free_edge_layer.hpp"
#include "updating/structure/solve/seen_through.hpp"

namespace tapfit::updating {

using Eigen::MatrixXd;

namespace {

// The limit of fine meshes is at 4/3 where convergence is quadratic, at 2 where
// it is linear.
constexpr double size_sd = 0.5;

// Of the edges' layer anything between nothing and all may be missing, or too
// much: evenly spread, sd 0.29.
constexpr double edges_sd = 0.3;

}  // namespace

std::vector<CorrectionPart> corrections(const structure::Deck& deck,
                                        const MatrixXd& V,
                                        const CorrectedModes& modes,
                                        const std::vector<MassForm>& mass) {
  const auto in_base = [&V](const MatrixXd& of_modes) {
    MatrixXd whole = MatrixXd::Zero(V.cols(), V.cols());
    whole.topLeftCorner(of_modes.rows(), of_modes.cols()) = of_modes;
    return whole;
  };
  const MeshShift size = mesh_shift(modes.split, modes.unsplit);
  std::vector<CorrectionPart> parts = {
      {{"mesh size", size_sd}, in_base(size.K), in_base(size.M)}};
  const structure::SparseMatrix twist = -structure::free_edge_layer(deck);
  MatrixXd K = structure::seen_through(V, twist);
  if (!K.isZero(0.0)) {
    parts.push_back(
        {{"mesh edges", edges_sd}, std::move(K), in_base({}), twist});
  }
  for (const FormModes& form : modes.forms) {
    // What would have to be taken off to leave it out: the other way round.
    const MeshShift shift = mesh_shift(modes.split, form.modes);
    parts.push_back({form.correction, in_base(-shift.K), in_base(-shift.M)});
  }
  for (const MassForm& form : mass) {
    parts.push_back(
        {form.correction, in_base({}), structure::seen_through(V, form.M)});
  }
  return parts;
}

}  // namespace tapfit::updating
