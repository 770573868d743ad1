// The FRFs of each run by themselves, against poles that other runs show.
#pragma once

#include "modal/checks/modal_constants.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <vector>

namespace tapfit::modal {

/// Indices into FrfSet::frfs by the run that they stand for.
using FrfsByRun = std::map<std::size_t, std::vector<std::size_t>>;

[[nodiscard]] FrfsByRun frfs_by_run(const signal::FrfSet& set);

/// Those FRFs alone, on the same lines.
[[nodiscard]] signal::FrfSet part_of(const signal::FrfSet& set,
                                     const std::vector<std::size_t>& frfs);

/// Whether a modal constant stands ten standard deviations out of the noise.
[[nodiscard]] bool is_clear(const ModalConstants& of, Eigen::Index pole);

/// Poles that the runs other than `run` show: so large a share of them, two at
/// the least.
/// @param all as modal_constants() of the whole set for these poles
[[nodiscard]] Eigen::VectorXcd shown_by_others(
    const FrfsByRun& runs,
    std::size_t run,
    const std::vector<ModalConstants>& all,
    const Eigen::VectorXcd& poles,
    double share);

/// What the poles leave of the FRFs, relative (rms).
[[nodiscard]] double left_by(const Eigen::VectorXcd& poles,
                             const signal::FrfSet& of);

}  // namespace tapfit::modal
