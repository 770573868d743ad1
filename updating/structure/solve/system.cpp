#include "updating/structure/solve/system.hpp"

namespace tapfit::structure {

std::vector<int> System::free_dofs() const {
  std::vector<int> free;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i] && !inactive[i]) free.push_back(static_cast<int>(i));
  }
  return free;
}

}  // namespace tapfit::structure
