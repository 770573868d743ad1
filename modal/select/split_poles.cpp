#include "modal/select/split_poles.hpp"

#include "modal/fit/residue_rank.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/mac.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double same_shape = 0.9;          // MAC of residues of split poles
constexpr double least_mpc_of_whole = 0.7;  // MPC of a mode that is not split

}  // namespace

bool is_split(const FrfMatrix& matrix, const ModalFit& fit, Index r) {
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (q == r) continue;
    const double apart = std::abs(fit.poles(q) - fit.poles(r));
    const double width =
        std::max(std::abs(fit.poles(q).real()), std::abs(fit.poles(r).real()));
    if (apart > 2.0 * width) continue;
    if (fit.contribution(q) < fit.contribution(r)) continue;
    const bool one_shape =
        mac(fit.residues.col(q), fit.residues.col(r))(0, 0) > same_shape;
    // Several references tell it better than badly known residues.
    const bool out_of_phase =
        matrix.references < 2 && fit.residues.rows() > 2 &&
        std::min(phase_collinearity(fit.residues.col(q)),
                 phase_collinearity(fit.residues.col(r))) < least_mpc_of_whole;
    if ((one_shape || out_of_phase) &&
        !holds_second_shape(matrix,
                            fit.residues.col(q) + fit.residues.col(r))) {
      return true;
    }
  }
  return false;
}

}  // namespace tapfit::modal
