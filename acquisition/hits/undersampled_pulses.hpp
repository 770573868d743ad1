// Blows that are over within a few samples, where no anti-alias filter has made
// them longer.
//
// The samples of a half sine that lasts w of them sum up to its impulse but for
//
//   sum_n 2 cos(pi n w) cos(2 pi n phi) / (1 - 4 n^2 w^2)    (Poisson's sum)
//
// of it, phi the place of the blow between two samples: the force's scale is
// off by as much, differently each time, and so is that of every FRF. A filter
// before the converter keeps the impulse; its ringing shows that it is there.
#pragma once

#include "acquisition/hits/hit_steps.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Largest relative error of the impulse of a half sine, w >= 1 samples long,
/// wherever it falls: 1 - x cot x, x = pi / (2 w). Exact for whole w, a bound
/// between.
[[nodiscard]] double impulse_error(double samples);

/// What to say of pulses shorter than three samples that ring nowhere; empty
/// where most pulses are longer or ring.
///
/// @param runs with their pulses found
/// @param rate of sampling [Hz]
[[nodiscard]] std::string undersampled_statement(
    const std::vector<HammerRun>& runs, double rate);

}  // namespace tapfit::acquisition
