// Properties of their own for elements that change by a factor: elements of one
// property and factor share a copy.
#pragma once

#include <map>
#include <utility>

namespace tapfit::structure {

/// A copy under a new number.
template <class Property>
Property& copied(std::map<int, Property>& properties, int id) {
  Property copy = properties.at(id);
  copy.id = properties.rbegin()->first + 1;
  return properties[copy.id] = copy;
}

/// Numbers of copies that are made once for each number and factor.
class PropertyCopies {
 public:
  /// @param make the copy's number from the number of what is copied
  template <class Make>
  int of(int id, double factor, const Make& make) {
    const auto [it, fresh] = made_.try_emplace({id, factor}, 0);
    if (fresh) it->second = make(id);
    return it->second;
  }

 private:
  std::map<std::pair<int, double>, int> made_;
};

}  // namespace tapfit::structure
