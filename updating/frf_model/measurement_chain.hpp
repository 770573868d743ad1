// What the measuring chain makes of the structure's FRFs: effects that sit in
// channels, not in the structure. Internal to frf_model.
#pragma once

#include "updating/frf_model/run_response.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Whether the last effect acts in channels alone: it leaves the points of the
/// sheet where the others have them.
[[nodiscard]] bool is_passed_on(const effects::TestContext& context,
                                const std::vector<EffectInstance>& effects);

/// Multiplies the FRFs of an effect's channels in its runs, and their
/// derivatives.
/// @param first column of the effect's parameters in dH
void apply_channel_effect(const std::vector<MeasuredPair>& pairs,
                          const EffectInstance& placed,
                          std::size_t first,
                          const Eigen::VectorXcd& s,
                          ModelResponse& out);

/// The same for all channels at fault.
void apply_chain(const std::vector<MeasuredPair>& pairs,
                 const ModalState& shared,
                 const Eigen::VectorXcd& s,
                 ModelResponse& out);

}  // namespace tapfit::updating
