#include "updating/reduction/base_matrices.hpp"

#include "updating/effects/stiffness_loss.hpp"
#include "updating/properties/uncertain_parts.hpp"

namespace tapfit::updating {

using Eigen::MatrixXd;

BaseMatrices ReducedBase::at(const std::vector<double>& factor,
                             const std::vector<double>& p) const {
  BaseMatrices sum{K, MatrixXd::Identity(size(), size())};
  for (std::size_t t = 0; t < part_power.size(); ++t) {
    const double c = part_coefficient(part_power[t], factor);
    if (c == 0.0) continue;
    sum.K += c * K_part[t];
    sum.M += c * M_part[t];
  }
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const StiffnessTerm& term = terms[k];
    if (p[k] == term.included) continue;
    sum.K += (p[k] - term.included) * term.at(factor);
    if (!term.is_thinned()) continue;
    const double c =
        effects::thickness_left(p[k]) - effects::thickness_left(term.included);
    sum.K += c * term.thickness_at(factor);
    sum.M += c * term.mass_at(factor);
  }
  return sum;
}

void ReducedBase::turn(const MatrixXd& Q) {
  const auto turn_one = [&Q](MatrixXd& A) {
    if (A.size() == 0) return;
    // A property of stiffness has no mass, one of mass no stiffness.
    A = A.isZero(0.0) ? MatrixXd(MatrixXd::Zero(Q.cols(), Q.cols()))
                      : MatrixXd(Q.transpose() * A * Q);
  };
  const auto turn_all = [&turn_one](std::vector<MatrixXd>& all) {
    for (MatrixXd& A : all) turn_one(A);
  };
  rows.turn(Q);
  turn_one(K);
  turn_all(K_part);
  turn_all(M_part);
  for (StiffnessTerm& term : terms) {
    turn_one(term.S);
    turn_one(term.T);
    turn_one(term.N);
    turn_all(term.S_part);
    turn_all(term.T_part);
    turn_all(term.N_part);
  }
}

}  // namespace tapfit::updating
