#include "updating/fit/rung.hpp"

namespace tapfit::updating {

std::string leading_kind(const Rung& rung) {
  return rung.added.substr(0, rung.added.find('|'));
}

}  // namespace tapfit::updating
