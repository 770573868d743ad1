// What single elements of a deck add to its matrices, as they are and as
// uncertain properties change them. Each is worked out when it is first asked
// for, and kept: hypotheses about the same elements are many.
//
// An element that is thinned to t / t_0 = c keeps c^3 of what bends it across
// its thickness and, if it is flat, of what twists it, and c of the rest:
//
//   K(c) = K + (c^3 - 1) (K - K_t) + (c - 1) K_t,   M(c) = c M
//
// K_t: a shell's membrane; a bar's axial stiffness, its bending in the plane in
// which it is stiffer, and a share of its twist (bar_thickness.hpp). A laminate
// or a solid has none.
#pragma once

#include "updating/properties/uncertain_parts.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace tapfit::updating {

class ElementParts {
 public:
  /// @param deck must outlive this
  ElementParts(const structure::Deck& deck,
               std::vector<acquisition::UncertainProperty> uncertain);

  struct Sum {
    structure::SparseMatrix K;         ///< dofs of the deck, square
    structure::SparseMatrix M;         ///< with WTMASS
    std::vector<UncertainPart> parts;  ///< of these elements alone
  };
  /// What goes with the cube of the thickness, and what with the thickness; as
  /// many parts of the same powers in both.
  struct ByThickness {
    Sum cube;       ///< K - K_t, no mass
    Sum thickness;  ///< K_t and M
  };

  /// Of shells, bars, rods and solids; ids that are none of these add nothing.
  /// May be asked on several threads.
  [[nodiscard]] Sum of(const std::set<int>& elements) const {
    return sum_of(elements, Share::Whole);
  }
  [[nodiscard]] ByThickness by_thickness(const std::set<int>& elements) const;

 private:
  enum class Share { Whole, Thickness };  // all of it; K_t alone
  [[nodiscard]] Sum sum_of(const std::set<int>& elements, Share share) const;
  // Over the degrees of freedom of the element's grids.
  struct Own {
    std::vector<int> dofs;  // of the deck
    Sum sum;
  };
  using Key = std::pair<int, Share>;
  [[nodiscard]] std::shared_ptr<const Own> own(const Key& key) const;
  [[nodiscard]] Own work_out(const Key& key) const;

  const structure::Deck* deck_;
  structure::Deck cards_;            // its properties and materials
  structure::Deck thickness_cards_;  // the same, of K_t
  std::vector<acquisition::UncertainProperty> uncertain_;
  std::map<int, std::size_t> at_;  // position among those of its kind
  mutable std::mutex mutex_;
  mutable std::map<Key, std::shared_ptr<const Own>> known_;
};

}  // namespace tapfit::updating
