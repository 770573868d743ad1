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
/// is above a tenth (a coherence of 0.99) and far above that of the others.
/// Where lines count alike and each adds the variance q^2, one more makes a
/// mean worse that has a q^2 of more than twice the mean's.
///
/// @return how many and where; empty where all stay
[[nodiscard]] std::string leave_out_noisy_lines(FrfSet& set);

}  // namespace tapfit::signal
