#include "updating/reduction/missing_vectors.hpp"

#include "updating/reduction/held_motions.hpp"
#include "updating/reduction/subspace.hpp"

#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::SparseMatrix;

MatrixXd missing_vectors(const HeldBase& held,
                         const PlainModes& modes,
                         const ReleasedSystem& released,
                         const std::vector<StiffnessChange>& changes,
                         const std::vector<int>& fresh,
                         const std::vector<int>& seen) {
  std::vector<MatrixXd> blocks;
  if (!fresh.empty()) blocks.push_back(held.answers.to_points(fresh));
  if (!changes.empty()) {
    std::vector<ChangeRange> ranges;
    for (const ScaledStiffness& scaled : released.scaled) {
      if (seen.empty()) break;
      ranges.push_back(range_of(
          released, scaled, changes[scaled.change].kind, modes, held.system));
    }
    blocks.push_back(constraint_modes(held, released, ranges, seen));
  }
  if (!released.held.empty()) {
    blocks.push_back(held_modes(held, released.held));
  }
  const Index n = held.system.dofs();
  const auto add_loss = [&](const ScaledStiffness& lost) {
    LostMatrices own{lost.S.topLeftCorner(n, n), {}, {}};
    if (lost.is_thinned()) {
      own.T = lost.thickness.K.topLeftCorner(n, n);
      own.N = lost.thickness.M.topLeftCorner(n, n);
    }
    blocks.push_back(loss_modes(held, own, loss_range.lower));
  };
  for (std::size_t c = 0; c < changes.size(); ++c) {
    const ChangeKind kind = changes[c].kind;
    ScaledStiffness all;
    for (const ScaledStiffness& scaled : released.scaled) {
      if (scaled.change != c) continue;
      if (kind == ChangeKind::Preload) {
        const double most =
            range_of(released, scaled, kind, modes, held.system).upper;
        blocks.push_back(added_modes(held, scaled.S.topLeftCorner(n, n), most));
      }
      if (kind != ChangeKind::Elements) continue;
      if (all.S.size() == 0) {
        add_loss(scaled);
        all = scaled;
      } else {
        all.S += scaled.S;
        if (!all.is_thinned()) continue;
        all.thickness.K += scaled.thickness.K;
        all.thickness.M += scaled.thickness.M;
      }
    }
    // With what is lost beside it: in between it runs smoothly.
    if (!changes[c].beside.empty()) add_loss(all);
  }
  return join(std::move(blocks));
}

}  // namespace tapfit::updating
