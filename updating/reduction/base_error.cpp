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

namespace {

// What unit forces on some degrees of freedom leave, I - (K + s^2 M) V q.
MatrixXcd forces_left(const structure::System& system,
                      const MatrixXd& V,
                      const MatrixXcd& q,
                      const std::complex<double>& s,
                      const std::vector<int>& moving) {
  const MatrixXd re = V * q.real();
  const MatrixXd im = V * q.imag();
  MatrixXcd R(V.rows(), q.cols());
  R.real() = -structure::symmetric_product(system.M, re);
  R.imag() = -structure::symmetric_product(system.M, im);
  R *= s * s;
  R.real() -= structure::symmetric_product(system.K, re);
  R.imag() -= structure::symmetric_product(system.K, im);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    R(moving[k], static_cast<Index>(k)) += 1.0;
  }
  return R;
}

}  // namespace

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
  double worst = 0.0;
  for (const double part : {0.3, 0.65, 1.0}) {
    const std::complex<double> s =
        2.0 * std::numbers::pi * part * high_hz * std::complex(0.03, 1.0);
    const VectorXcd g = (stiffness.array() + s * s).inverse();
    const MatrixXcd q = g.asDiagonal() * rows.transpose();
    const MatrixXcd H = rows * q;
    const MatrixXcd R = forces_left(system, V, q, s, moving);
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
