#include "updating/studies/truss_sensitivity.hpp"

#include "updating/properties/uncertain_parts.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/system.hpp"
#include "updating/studies/sensitivity.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using std::complex;

namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double>(end - start).count();
}

}  // namespace

TrussSensitivity::TrussSensitivity(const PropertyStudy& study,
                                   const Dof& point,
                                   const VectorXcd& s) {
  const structure::System system = structure::assemble(study.deck());
  const std::vector<int> free = system.free_dofs();
  const MatrixXd K = structure::extract(system.K, free);
  const MatrixXd M = structure::extract(system.M, free);
  for (const complex<double>& line : s) {
    const MatrixXcd Z = K + line * line * M;
    H_.emplace_back(Z.inverse());
  }
  for (const auto& property : study.bundle().uncertain) {
    const auto parts = uncertain_parts(study.deck(), {property});
    const MatrixXd dK = structure::extract(parts.front().K, free);
    dK_.emplace_back(dK.cast<complex<double>>());
  }
  const int index = 6 * static_cast<int>(study.deck().grid_index(point.node)) +
                    point.component - 1;
  point_ = std::lower_bound(free.begin(), free.end(), index) - free.begin();
}

VectorXcd TrussSensitivity::analytic(const MatrixXcd& dK) const {
  VectorXcd S(static_cast<Index>(H_.size()));
  for (Index l = 0; l < S.size(); ++l) {
    const MatrixXcd& H = H_[static_cast<std::size_t>(l)];
    S(l) = analytic_sensitivity(H, dK)(point_, point_);
  }
  return S;
}

// A perturbation far below 1 leaves the truss whole.
VectorXcd TrussSensitivity::finite(const MatrixXcd& dK,
                                   double from,
                                   double to) const {
  const LowRankChange up = factor_change(to * dK);
  const LowRankChange down = factor_change(from * dK);
  VectorXcd S(static_cast<Index>(H_.size()));
  for (Index l = 0; l < S.size(); ++l) {
    const MatrixXcd& H = H_[static_cast<std::size_t>(l)];
    const MatrixXcd after = changed_receptance(H, up).value();
    const MatrixXcd before = changed_receptance(H, down).value();
    S(l) = (after - before)(point_, point_) / (to - from);
  }
  return S;
}

SensitivityRow TrussSensitivity::compare(double perturbation) const {
  SensitivityRow row{perturbation};
  const double share = 1.0 / static_cast<double>(dK_.size());
  const double half = 0.5 * perturbation;
  for (const MatrixXcd& dK : dK_) {
    const VectorXcd exact = analytic(dK);
    row.one_sided +=
        share * sensitivity_error(exact, finite(dK, 0.0, perturbation));
    row.centred += share * sensitivity_error(exact, finite(dK, -half, half));
  }
  return row;
}

SensitivityTime TrussSensitivity::time() const {
  constexpr double dP = 1e-3;
  const MatrixXcd& dK = dK_.front();
  double sum = 0.0;  // so that no work can be left out
  SensitivityTime time;
  time.analytic = seconds_of([&] {
    for (const MatrixXcd& H : H_) sum += analytic_sensitivity(H, dK).norm();
  });
  time.finite = seconds_of([&] {
    const LowRankChange change = factor_change(dP * dK);
    for (const MatrixXcd& H : H_) {
      sum += finite_sensitivity(H, change, dP).value().norm();
    }
  });
  return std::isfinite(sum) ? time : SensitivityTime{};
}

}  // namespace tapfit::updating
