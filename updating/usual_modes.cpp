#include "updating/usual_modes.hpp"

#include "acquisition/input_error.hpp"
#include "modal/identify_modes.hpp"

namespace tapfit::updating {

std::optional<modal::ModeSet> usual_modes(const signal::FrfSet& frfs,
                                          const Progress& progress) {
  try {
    return modal::identify_modes(frfs, {}, progress);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace tapfit::updating
