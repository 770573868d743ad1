#include "updating/frf_model/model_modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <numeric>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

bool is_diagonal(const MatrixXd& A) {
  const double off = (A - MatrixXd(A.diagonal().asDiagonal())).norm();
  return off <= 1e-9 * A.norm();
}

std::vector<std::size_t> by_frequency(const VectorXd& omega) {
  std::vector<std::size_t> order(static_cast<std::size_t>(omega.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return omega(static_cast<Index>(a)) < omega(static_cast<Index>(b));
  });
  return order;
}

}  // namespace

BaseModes solve_modes(const MatrixXd& K, const MatrixXd& M, bool in_modes) {
  BaseModes modes;
  if (in_modes && M.isIdentity(1e-14) && is_diagonal(K)) {
    // Modes in their first order: a common factor does not change places.
    modes.omega = K.diagonal().cwiseMax(0.0).cwiseSqrt();
    modes.phi = MatrixXd::Identity(K.rows(), K.cols());
    return modes;
  }
  const auto take = [&modes](const auto& solver) {
    modes.omega = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    modes.phi = solver.eigenvectors();
  };
  if (M.isIdentity(1e-14)) {
    take(Eigen::SelfAdjointEigenSolver<MatrixXd>(K));
  } else {
    take(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(K, M));
  }
  return modes;
}

ModalMatrices with_changes(const BaseModes& modes,
                           const std::vector<ModalModification>& changes,
                           const ModelState& state) {
  const Index n = modes.phi.rows();
  MatrixXd dK = MatrixXd::Zero(n, n);
  MatrixXd dM = dK;
  for (const ModalModification& c : changes) {
    const double p = state.effects[c.effect].p[c.parameter];
    if (c.dK.size() > 0) dK += p * c.dK;
    if (c.dM.size() > 0) dM += p * c.dM;
  }
  ModalMatrices with{modes.phi.transpose() * dK * modes.phi,
                     modes.phi.transpose() * dM * modes.phi};
  with.K.diagonal() += modes.omega.cwiseAbs2();
  with.M.diagonal().array() += 1.0;
  return with;
}

BaseModes modes_with(const BaseModes& modes,
                     const std::vector<ModalModification>& changes,
                     const ModelState& state) {
  const auto [K, M] = with_changes(modes, changes, state);
  BaseModes with = solve_modes(K, M);
  with.phi = (modes.phi * with.phi).eval();
  return with;
}

std::vector<int> by_order(const std::vector<int>& of,
                          const VectorXd& from,
                          const VectorXd& to) {
  const std::vector<std::size_t> before = by_frequency(from);
  const std::vector<std::size_t> after = by_frequency(to);
  std::vector<int> result(of.size());
  for (std::size_t m = 0; m < of.size(); ++m) {
    result[after[m]] = of[before[m]];
  }
  return result;
}

}  // namespace tapfit::updating
