#include "updating/reduction/stiffness_change.hpp"

#include "updating/properties/uncertain_parts.hpp"

namespace tapfit::updating {
namespace {

using Eigen::MatrixXd;
using Powers = std::vector<std::vector<int>>;

MatrixXd sum_at(const MatrixXd& nominal,
                const std::vector<MatrixXd>& parts,
                const Powers& power,
                const std::vector<double>& factor) {
  MatrixXd sum = nominal;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    sum += part_coefficient(power[t], factor) * parts[t];
  }
  return sum;
}

MatrixXd slope_of(const std::vector<MatrixXd>& parts,
                  const Powers& power,
                  const std::vector<double>& factor,
                  std::size_t j) {
  MatrixXd sum;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const double c = part_slope(power[t], factor, j);
    if (c == 0.0) continue;
    if (sum.size() == 0) sum.setZero(parts[t].rows(), parts[t].cols());
    sum += c * parts[t];
  }
  return sum;
}

}  // namespace

MatrixXd StiffnessTerm::at(const std::vector<double>& factor) const {
  return sum_at(S, S_part, part_power, factor);
}

MatrixXd StiffnessTerm::thickness_at(const std::vector<double>& factor) const {
  return sum_at(T, T_part, part_power, factor);
}

MatrixXd StiffnessTerm::mass_at(const std::vector<double>& factor) const {
  return sum_at(N, N_part, part_power, factor);
}

MatrixXd StiffnessTerm::slope(const std::vector<double>& factor,
                              std::size_t j) const {
  return slope_of(S_part, part_power, factor, j);
}

MatrixXd StiffnessTerm::thickness_slope(const std::vector<double>& factor,
                                        std::size_t j) const {
  return slope_of(T_part, part_power, factor, j);
}

MatrixXd StiffnessTerm::mass_slope(const std::vector<double>& factor,
                                   std::size_t j) const {
  return slope_of(N_part, part_power, factor, j);
}

}  // namespace tapfit::updating
