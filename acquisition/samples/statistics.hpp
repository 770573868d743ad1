// Median and thinned values of many samples.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

/// Median, of an even number the upper one of the middle; 0 for no values.
/// Takes a copy, because it reorders.
[[nodiscard]] double median(Eigen::VectorXd values);
[[nodiscard]] double median(const std::vector<double>& values);

/// Places of at most `most` of n values, from the whole length: one out of each
/// of as many equal parts, at a place that differs from part to part, so that
/// no hum is in step with them.
[[nodiscard]] std::vector<Eigen::Index> thinned_places(Eigen::Index n,
                                                       Eigen::Index most);

/// The values at those places.
[[nodiscard]] Eigen::VectorXd thinned(
    const Eigen::Ref<const Eigen::VectorXd>& values, Eigen::Index most);

}  // namespace tapfit::acquisition
