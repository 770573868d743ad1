// What single elements of a deck add to its matrices, as they are and as
// uncertain properties change them. Each is worked out when it is first asked
// for, and kept: hypotheses about the same elements are many.
#pragma once

#include "updating/properties/uncertain_parts.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <set>
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
  /// Of shells, bars, rods and solids; ids that are none of these add nothing.
  /// May be asked on several threads.
  [[nodiscard]] Sum of(const std::set<int>& elements) const;

 private:
  // Over the degrees of freedom of the element's grids.
  struct Own {
    std::vector<int> dofs;  // of the deck
    Sum sum;
  };
  [[nodiscard]] std::shared_ptr<const Own> own(int element) const;
  [[nodiscard]] Own work_out(int element) const;

  const structure::Deck* deck_;
  structure::Deck cards_;  // its properties and materials
  std::vector<acquisition::UncertainProperty> uncertain_;
  std::map<int, std::size_t> at_;  // position among those of its kind
  mutable std::mutex mutex_;
  mutable std::map<int, std::shared_ptr<const Own>> known_;
};

}  // namespace tapfit::updating
