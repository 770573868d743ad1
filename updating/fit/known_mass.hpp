// What weighing a structure says of its parameters:
//
//   k(theta) = (ln m(theta) - ln m_weighed) / sd
//
// m is the deck's mass with the uncertain properties as they are, and what
// masses and absorbers add; sensors are not weighed.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/minimiser/minimise.hpp"
#include "updating/properties/uncertain_parts.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct KnownMass {
  double kg = 0.0;  ///< as weighed
  double sd = 0.0;  ///< of ln m, with what is seldom in a deck
};

[[nodiscard]] KnownMass known_mass(const acquisition::Weighed& weighed);

/// A structure's mass by its parameters' logarithms, see pack().
struct MassLaw {
  double deck_kg = 0.0;
  std::vector<PartMass> parts;           ///< of its uncertain properties
  Eigen::Index properties = 0;           ///< these come first
  std::vector<Eigen::Index> added = {};  ///< positions of masses on it

  /// k and its derivatives, one row.
  [[nodiscard]] Residuals residual(const KnownMass& known,
                                   const Eigen::VectorXd& theta) const;
};

}  // namespace tapfit::updating
