// Which lines of FRFs stay. Some say more of the noise than of the structure:
// those below the first mode of a stiff one, where next to nothing moves.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::signal {

/// The lines given of all FRFs, and no others.
/// @param keep ascending, counted from 0
void keep_lines(const std::vector<Eigen::Index>& keep, FrfSet& set);

/// Takes lines out on which the noise of all FRFs together,
///
///   q^2 = sum_f E|dH_f|^2 / sum_f |H_f|^2,
///
/// is far above that of the others. A model leaves a tenth of a line, too,
/// where noise is no matter (0.3 % in frequency of a peak 3 % wide): each adds
/// the variance q^2 + 0.01 where lines count alike, and one more makes a mean
/// worse that adds more than twice the mean's. Where that leaves fewer than
/// half, it is the test that is noisy, and all stay.
///
/// @return how many and where; empty where all stay
[[nodiscard]] std::string leave_out_noisy_lines(FrfSet& set);

}  // namespace tapfit::signal
