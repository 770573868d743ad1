#include "updating/effects/effect_ref.hpp"

#include <fmt/format.h>

namespace tapfit::updating {

std::string effect_text(const std::string& effect, const Location& where) {
  const std::string place = describe(where);
  return place.starts_with("everywhere")
             ? effect
             : fmt::format("{} at {}", effect, place);
}

}  // namespace tapfit::updating
