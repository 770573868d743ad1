// FRFs and how good they are, as JSON and as text.
#pragma once

#include "signal/frf_set/convert.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::tui {

/// {"frfs": [{"response", "reference", "type", "unit", "lines",
/// "mean_coherence", "median_sd_percent"}]}
///
/// @param form what the FRFs are called and written as
[[nodiscard]] nlohmann::ordered_json frf_json(
    const signal::FrfSet& frfs,
    signal::FrfForm form = signal::FrfForm::Accelerance);

/// A table with one line per FRF.
[[nodiscard]] std::string frf_text(
    const signal::FrfSet& frfs,
    signal::FrfForm form = signal::FrfForm::Accelerance);

/// Median over lines of the standard deviation of H, in percent of |H|.
/// Lines where H is zero are left out; 0 when none is left.
[[nodiscard]] double median_sd_percent(const signal::Frf& frf);

}  // namespace tapfit::tui
