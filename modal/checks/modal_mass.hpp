// The size of the modal constants against the mass of the structure. A mode of
// unit modal mass has a mean square of 1 / m over the structure's mass,
//
//   integral phi^2 dm = 1,
//
// so that z m = phi_o phi_i m is of the order of 1: at most some 16 at the
// corners of plates, less near supports and nodal lines. A mean over many
// points and modes that is far from it shows a sensitivity in the wrong unit.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::modal {

struct ChannelSize {
  std::size_t channel = 0;
  double z_per_kg = 0.0;  ///< median over modes of the rms over FRFs of |z|
};

/// Of the channels that measure along the blows.
[[nodiscard]] std::vector<ChannelSize> channel_sizes(const signal::FrfSet& set,
                                                     const ModeSet& modes);

/// Whether the resonances of all channels together are those of such a
/// structure, as far as no structure explains the rest; so without channels.
/// @param mass_kg above zero
[[nodiscard]] bool have_mass(const std::vector<ChannelSize>& sizes,
                             double mass_kg);

/// @param mass_kg of the structure; 0 where it is not known
[[nodiscard]] std::vector<Finding> modal_mass_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes,
    double mass_kg);

}  // namespace tapfit::modal
