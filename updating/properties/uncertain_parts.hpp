// How K and M depend on the uncertain properties of the deck:
//
//   K(f) = K + sum_t c_t(f) K_t,   c_t(f) = prod_j (f_j - 1)^(power_tj)
//
// and M alike, f_j property j over its nominal value. Properties of the same
// elements multiply (E and the area of a beam), hence the mixed powers. The
// matrices are those of the polynomial through the deck's own at scaled
// properties: exact where K and M are polynomials, see PropertyLaw.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <vector>

namespace tapfit::updating {

struct UncertainPart {
  std::vector<int> power;  ///< per uncertain property; not all 0
  structure::SparseMatrix K;
  structure::SparseMatrix M;
};

/// Of one in translation: the mass is that of the deck plus sum_t c_t(f) kg_t.
struct PartMass {
  std::vector<int> power;
  double kg = 0.0;
};

/// c_t(f).
[[nodiscard]] double part_coefficient(const std::vector<int>& power,
                                      const std::vector<double>& factor);
/// d c_t / d f_j.
[[nodiscard]] double part_slope(const std::vector<int>& power,
                                const std::vector<double>& factor,
                                std::size_t j);

/// @throws InputError for a card or property that the deck does not have, or
///   one that is listed twice
[[nodiscard]] std::vector<UncertainPart> uncertain_parts(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain);

}  // namespace tapfit::updating
