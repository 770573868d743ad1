// The part of K and M that scales with an uncertain property of the deck.
#pragma once

#include "acquisition/test_bundle.hpp"
#include "updating/structure/system.hpp"

#include <set>
#include <string>
#include <vector>

namespace tapfit::updating {

/// K(f) = K + (f - 1) K_part, M(f) = M + (f - 1) M_part, where f is the
/// property over its nominal value. Exact for E, G and rho.
struct UncertainPart {
  std::string name;      ///< "E:1": property and id, as in results
  std::string unit;      ///< "Pa", "kg/m^3"
  double nominal = 0.0;  ///< the deck's value
  double sd = 0.0;       ///< prior standard deviation of ln f
  std::set<int> elements;
  structure::SparseMatrix K;
  structure::SparseMatrix M;
};

/// @throws InputError for a material or property that the deck does not have,
///   or one that cannot be fitted
[[nodiscard]] std::vector<UncertainPart> uncertain_parts(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain);

}  // namespace tapfit::updating
