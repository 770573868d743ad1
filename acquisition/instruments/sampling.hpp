// How an array of a file is sampled, by what stands beside it: a rate, a step,
// a list of times.
#pragma once

#include "acquisition/readers/named_array.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace tapfit::acquisition {

struct Sampling {
  double hz = 0.0;
  std::optional<double> spread;  ///< relative, where times gave it
};

/// Whether the values rise by one step throughout, as times and numbers of
/// samples do and no record of a motion.
[[nodiscard]] bool is_axis(const Eigen::VectorXd& values);

/// Of the array of that name: its own attribute, else what stands nearest to it
/// in the file, a rate or step before a list of times; at last a list without a
/// usual name that rises evenly, but for numbers of samples.
///
/// @param samples how many it has
/// @return empty where the file does not tell, or by times that are not evenly
///   spaced
[[nodiscard]] std::optional<Sampling> sampling_of(
    const std::vector<NamedArray>& all,
    std::string_view name,
    Eigen::Index samples);

}  // namespace tapfit::acquisition
