#include "updating/measurement/default_identification.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/identify/identify_modes.hpp"

namespace tapfit::updating {

std::optional<modal::ModeSet> default_identification(
    const signal::FrfSet& frfs,
    const std::optional<std::array<double, 2>>& band_hz,
    const Progress& progress) {
  modal::IdentifyOptions options;
  options.band_hz = band_hz;
  try {
    return modal::identify_modes(frfs, options, progress);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace tapfit::updating
