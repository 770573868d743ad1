// What the measuring chain makes of the structure's FRFs: effects that sit in
// channels, not in the structure. Internal to frf_model.
#pragma once

#include "updating/frf_model/run_lines.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Multiplies the FRFs of channels at fault, and their derivatives.
void record(const std::vector<MeasuredPair>& pairs,
            const ModalState& shared,
            const Eigen::VectorXcd& s,
            ModelResponse& out);

}  // namespace tapfit::updating
