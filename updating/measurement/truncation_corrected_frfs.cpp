#include "updating/measurement/truncation_corrected_frfs.hpp"

#include "signal/estimate/estimate_frfs.hpp"
#include "updating/measurement/default_identification.hpp"
#include "updating/measurement/undecayed_poles.hpp"

#include <array>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

// Beyond it the lines are noise, and so would be the modes. FRFs of a test with
// a band of its own have no others.
std::optional<std::array<double, 2>> excited_band(
    const acquisition::TestBundle& bundle, const acquisition::HitSet& hits) {
  if (bundle.band_hz) return std::nullopt;
  return std::array{0.0, hits.usable_bandwidth_hz};
}

}  // namespace

TruncationCorrectedFrfs estimate_truncation_corrected_frfs(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const Progress& progress) {
  constexpr int passes = 6;
  TruncationCorrectedFrfs result;
  signal::FrfOptions options;
  const auto estimate = [&] {
    return signal::estimate_frfs(bundle, recordings, hits, options, progress);
  };
  result.set = estimate();
  const auto band = excited_band(bundle, hits);
  for (int pass = 0; pass < passes; ++pass) {
    std::optional<modal::ModeSet> modes =
        default_identification(result.set, band, progress);
    if (!modes) break;
    Eigen::VectorXcd poles = undecayed_poles(*modes, hits);
    if (have_converged(result.poles, poles)) {
      if (!band) result.modes = std::move(modes);
      break;
    }
    result.poles = std::move(poles);
    options.lasting_poles = result.poles;
    result.set = estimate();
  }
  return result;
}

}  // namespace tapfit::updating
