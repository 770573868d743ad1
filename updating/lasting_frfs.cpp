#include "updating/lasting_frfs.hpp"

#include "signal/estimate_frfs.hpp"
#include "updating/slow_poles.hpp"
#include "updating/usual_modes.hpp"

#include <utility>

namespace tapfit::updating {
LastingFrfs estimate_lasting_frfs(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const Progress& progress) {
  constexpr int passes = 6;
  LastingFrfs result;
  signal::FrfOptions options;
  const auto estimate = [&] {
    return signal::estimate_frfs(bundle, recordings, hits, options, progress);
  };
  result.set = estimate();
  for (int pass = 0; bundle.band_hz && pass < passes; ++pass) {
    std::optional<modal::ModeSet> modes = usual_modes(result.set, progress);
    if (!modes) break;
    Eigen::VectorXcd poles = slow_poles(*modes, hits);
    if (at_rest(result.poles, poles)) {
      result.modes = std::move(modes);
      break;
    }
    result.poles = std::move(poles);
    options.lasting_poles = result.poles;
    result.set = estimate();
  }
  return result;
}

}  // namespace tapfit::updating
