// The room updating/properties. Properties of the model that the engineer does
// not trust: which elements they concern, how K and M depend on them, how they
// are written back.
// In:  Deck and the bundle's list.
// Out: Parts of K and M with their laws; changes of cards.
// May include: its row in CONTRIBUTING.md.
//
// Properties of the deck's cards that a test may call uncertain: where they
// stand, which elements they concern, and the deck with one of them scaled.
//
//   material (MAT1, MAT8)          E (every modulus), rho, nu; MAT8: E1 E2 G12
//            (MAT2, MAT9)          E (every modulus), rho
//   element_property (PSHELL)      t
//                    (PCOMP)       t (of all plies alike), (PSHEAR) t
//                    (PBAR, PBEAM) A I1 I2 J
//                    (PROD, PTUBE) A J
//   material 1 of given matrices   E (all stiffness), rho (all mass)
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"

#include <set>
#include <string>

namespace tapfit::updating {

/// How K and M of the elements depend on a property's factor.
struct PropertyLaw {
  std::string name;      ///< "E:1": property and id, as in results
  std::string unit;      ///< "Pa", "kg/m^3", ...
  double nominal = 0.0;  ///< the deck's value
  std::set<int> elements;
  /// Degree of the polynomial in the factor; 0: does not enter. Where an
  /// element is rational in the property (transverse shear, released bars, the
  /// moduli of a MAT8), a polynomial of degree 4 stands for it.
  int stiffness_degree = 0;
  int mass_degree = 0;
};

/// @param place of the entry in test.json, for messages
/// @throws InputError for a card or property that the deck does not have
[[nodiscard]] PropertyLaw property_law(
    const structure::Deck& deck,
    const acquisition::UncertainProperty& uncertain,
    const std::string& place);

/// Multiplies the property by a factor, and with it what depends on it: E the
/// shear moduli, nu the G of a MAT1.
/// @param uncertain one that property_law() accepts
void scale_property(structure::Deck& deck,
                    const acquisition::UncertainProperty& uncertain,
                    double factor);

}  // namespace tapfit::updating
