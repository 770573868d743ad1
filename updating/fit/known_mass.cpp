#include "updating/fit/known_mass.hpp"

#include <cmath>

namespace tapfit::updating {

using Eigen::Index;

KnownMass known_mass(const acquisition::Weighed& weighed) {
  // Screws, glue and paint: a careful deck is some percent off.
  constexpr double seldom_in_a_deck = 0.025;
  return {weighed.mass_kg,
          std::hypot(0.01 * weighed.sd_percent, seldom_in_a_deck)};
}

Residuals MassLaw::residual(const KnownMass& known,
                            const Eigen::VectorXd& theta) const {
  std::vector<double> factor;
  for (Index j = 0; j < properties; ++j) factor.push_back(std::exp(theta(j)));
  double kg = deck_kg;
  Residuals at{Eigen::VectorXd(1), Eigen::MatrixXd::Zero(1, theta.size())};
  for (const PartMass& part : parts) {
    kg += part_coefficient(part.power, factor) * part.kg;
    for (std::size_t j = 0; j < part.power.size(); ++j) {
      at.J(0, static_cast<Index>(j)) +=
          part_slope(part.power, factor, j) * factor[j] * part.kg;
    }
  }
  for (const Index k : added) {
    at.J(0, k) = std::exp(theta(k));
    kg += at.J(0, k);
  }
  at.J /= kg * known.sd;
  at.r(0) = std::log(kg / known.kg) / known.sd;
  return at;
}

}  // namespace tapfit::updating
