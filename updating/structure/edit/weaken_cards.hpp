// Elements of a deck on properties and materials of their own, softer than the
// rest by a factor: copies of the property's card and of the MAT card behind
// it, with every modulus multiplied; the elements' cards name the copy.
// Elements that were thinned have a thinner PSHELL or PBAR on the old material;
// where that is another card, moduli and density are multiplied.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/rescale_cards.hpp"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tapfit::structure {

struct WeakElements {
  std::set<int> elements;
  double factor = 1.0;     ///< of their stiffness
  double thickness = 1.0;  ///< what is left of it: the cube root of the factor
                           ///< where they were thinned
};

class WeakenCards {
 public:
  /// Ids that the deck has not are taken for the copies.
  WeakenCards(const Deck& deck, const std::vector<WeakElements>& weak);

  /// @param scales what else is multiplied, in the copies too
  /// @param done as of rescale_cards(); all three must outlive the result
  [[nodiscard]] CardEdit edit(const std::vector<CardScale>& scales,
                              std::vector<bool>& done) const;

  /// An element's card on its new property; nothing for other cards.
  [[nodiscard]] std::optional<Card> moved(const Card& card) const;

 private:
  struct Copy {
    int id = 0;
    double factor = 1.0;  ///< of a material's moduli
    double density = 1.0;
    std::map<int, int> materials;          ///< of a property: old to new
    std::map<std::size_t, double> scales;  ///< of a property: field to factor
  };
  void place(const Deck& deck, const WeakElements& weak);
  [[nodiscard]] std::vector<Card> copies(const Card& card) const;
  [[nodiscard]] std::map<int, int> copied_materials(const std::set<int>& ids,
                                                    const WeakElements& weak);

  std::map<int, int> property_of_;  ///< element to its new property
  std::map<int, std::vector<Copy>> properties_;
  std::map<int, std::vector<Copy>> materials_;
  int next_property_ = 1;
  int next_material_ = 1;
};

}  // namespace tapfit::structure
