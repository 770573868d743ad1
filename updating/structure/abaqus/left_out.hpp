// What of a deck is not read though the model lacks something without it.
#pragma once

#include <string>

namespace tapfit::structure {

/// Keywords or element types that carry stiffness, mass or a constraint and are
/// not read.
struct LeftOut {
  std::string name;   ///< "CONTACT PAIR", "CPE8"
  std::string where;  ///< "file:line" of the first
  std::string text;   ///< line of the first, how many, the consequence
};

}  // namespace tapfit::structure
