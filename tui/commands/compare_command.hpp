// tapfit compare: the base model against the measurement.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/comparison/comparison.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tapfit::tui {

/// {"error", "pairs", "frac", "points", ...}. Where two runs measured the same
/// pair of points, `frac` and `frf_error` hold the worse one.
///
/// @param frfs the FRFs the comparison was made with, in the same order
/// @param dofs of the measured shapes, for CoMAC
[[nodiscard]] nlohmann::ordered_json compare_json(
    const updating::Comparison& comparison,
    const signal::FrfSet& frfs,
    const std::vector<Dof>& dofs = {});

/// Error and floor, paired modes, the worst points by CoMAC, the worst FRFs and
/// bands.
[[nodiscard]] std::string compare_text(const updating::Comparison& comparison,
                                       const signal::FrfSet& frfs,
                                       const std::vector<Dof>& dofs = {});

/// A table of paired modes; measured modes without a partner are left out.
[[nodiscard]] std::string pairs_text(
    const std::vector<updating::ModePair>& pairs);

}  // namespace tapfit::tui
