#include "updating/reduction/stiffness_change.hpp"

#include "updating/properties/uncertain_parts.hpp"

namespace tapfit::updating {

Eigen::MatrixXd StiffnessTerm::at(const std::vector<double>& factor) const {
  Eigen::MatrixXd sum = S;
  for (std::size_t t = 0; t < S_part.size(); ++t) {
    sum += part_coefficient(part_power[t], factor) * S_part[t];
  }
  return sum;
}

Eigen::MatrixXd StiffnessTerm::slope(const std::vector<double>& factor,
                                     std::size_t j) const {
  Eigen::MatrixXd sum;
  for (std::size_t t = 0; t < S_part.size(); ++t) {
    const double c = part_slope(part_power[t], factor, j);
    if (c == 0.0) continue;
    if (sum.size() == 0) sum.setZero(S.rows(), S.cols());
    sum += c * S_part[t];
  }
  return sum;
}

}  // namespace tapfit::updating
