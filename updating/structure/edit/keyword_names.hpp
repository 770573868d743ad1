// Names and lines of what is added to an Abaqus or CalculiX deck.
#pragma once

#include "updating/structure/edit/keyword_deck.hpp"

#include <set>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Sets and materials are called TAPFIT_1, TAPFIT_2, ..., on from those that
/// are there. In a deck with an instance what stands outside its part names
/// nodes by it.
class KeywordNames {
 public:
  explicit KeywordNames(const KeywordDeck& deck);

  [[nodiscard]] std::string next();
  /// A node as *BOUNDARY names it.
  [[nodiscard]] std::string node(int id) const;

 private:
  int last_ = 0;
  int raised_by_ = 0;          // ids of the assembly's own nodes
  std::set<int> of_assembly_;  // as raised
  std::string instance_;       // "" none
};

/// *ELSET with its elements.
[[nodiscard]] std::vector<std::string> element_set(
    const std::string& name, const std::vector<int>& elements);

/// Lines of *BOUNDARY: components ("1245") of a node as it is named.
[[nodiscard]] std::vector<std::string> boundary_lines(
    const std::string& node, const std::string& components);

}  // namespace tapfit::structure
