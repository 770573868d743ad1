#include "updating/reduction/base_error.hpp"

#include "updating/structure/solve/symmetric_product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <iterator>
#include <numbers>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

double base_error(const structure::System& system,
                  const ResidualFlexibility& answers,
                  const MatrixXd& V,
                  const Eigen::VectorXd& stiffness,
                  const std::vector<int>& points,
                  double high_hz) {
  std::vector<int> moving;
  std::copy_if(
      points.begin(), points.end(), std::back_inserter(moving), [&V](int dof) {
        return !V.row(dof).isZero(0.0);
      });
  if (moving.empty()) return 0.0;
  const auto count = static_cast<Index>(moving.size());
  const MatrixXd rows = V(moving, Eigen::all);
  const MatrixXd KV = structure::symmetric_product(system.K, V);
  const MatrixXd MV = structure::symmetric_product(system.M, V);
  double worst = 0.0;
  for (const double part : {0.3, 0.65, 1.0}) {
    const std::complex<double> s =
        2.0 * std::numbers::pi * part * high_hz * std::complex(0.03, 1.0);
    const VectorXcd g = (stiffness.array() + s * s).inverse();
    const MatrixXcd q = g.asDiagonal() * rows.transpose();
    const MatrixXcd H = rows * q;
    MatrixXcd R = -(KV * q + s * s * (MV * q));
    for (Index k = 0; k < count; ++k) {
      R(moving[static_cast<std::size_t>(k)], k) += 1.0;
    }
    MatrixXcd answered(R.rows(), count);
    answered.real() = answers.to(R.real());
    answered.imag() = answers.to(R.imag());
    worst = std::max(worst, (R.transpose() * answered).norm() / H.norm());
  }
  return worst;
}

std::string base_error_warning(double error) {
  constexpr double poor = 1e-3;
  if (error <= poor) return {};
  return fmt::format(
      "the model's FRFs are reduced to no better than {:.0e} of themselves, "
      "and what is compared and identified is worth no more: look for far too "
      "stiff, soft or light parts",
      error);
}

}  // namespace tapfit::updating
