#include "modal/mode_set/complexity.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::modal {

using Complex = std::complex<double>;

Complex turn_to_real(const Eigen::VectorXcd& shape) {
  const Complex sum = (shape.array() * shape.array()).sum();
  return std::polar(1.0, -0.5 * std::arg(sum));
}

Eigen::VectorXd real_shape(const Eigen::VectorXcd& shape) {
  return (shape * turn_to_real(shape)).real();
}

double phase_collinearity(const Eigen::VectorXcd& shape) {
  const double xx = shape.real().squaredNorm();
  const double yy = shape.imag().squaredNorm();
  const double xy = shape.real().dot(shape.imag());
  const double sum = xx + yy;
  if (sum <= 0.0) return 0.0;
  return ((xx - yy) * (xx - yy) + 4.0 * xy * xy) / (sum * sum);
}

double mean_phase_deviation(const Eigen::VectorXcd& shape) {
  const Complex turn = turn_to_real(shape);
  double angles = 0.0;
  double weights = 0.0;
  for (const Complex& value : shape) {
    const Complex turned = value * turn;
    // The angle to the line, wherever on it the point lies.
    angles += std::abs(value) *
              std::atan2(std::abs(turned.imag()), std::abs(turned.real()));
    weights += std::abs(value);
  }
  if (weights <= 0.0) return 0.0;
  return angles / weights * 180.0 / std::numbers::pi;
}

}  // namespace tapfit::modal
