// What the measuring chain makes of the structure's FRFs: effects that sit in
// channels, not in the structure. Internal to frf_model.
#pragma once

#include "updating/frf_model/run_lines.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Column of the point that each pair's response channel really felt: its own,
/// or another channel's of the same run where the two were swapped.
[[nodiscard]] std::vector<Eigen::Index> felt_responses(
    const std::vector<MeasuredPair>& pairs, const ModelState& state);

/// Whether an effect acts in channels alone, and each records its own sensor.
[[nodiscard]] bool is_passed_on(const std::vector<MeasuredPair>& pairs,
                                const PlacedEffect& placed);

/// Multiplies the FRFs of an effect's channels, and their derivatives.
/// @param first column of the effect's parameters in dH
void record_through(const std::vector<MeasuredPair>& pairs,
                    const PlacedEffect& placed,
                    std::size_t first,
                    const Eigen::VectorXcd& s,
                    ModelResponse& out);

/// The same for all channels at fault.
void record(const std::vector<MeasuredPair>& pairs,
            const ModalState& shared,
            const Eigen::VectorXcd& s,
            ModelResponse& out);

}  // namespace tapfit::updating
