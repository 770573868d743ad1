// The scales by which raw counts of a TDMS channel become values, where they
// were stored unscaled.
//
//   Linear      y = Slope x + Y_Intercept
//   Polynomial  y = sum_k Coefficients[k] x^k
//
// Each takes the raw counts or the result of an earlier one.
#pragma once

#include "acquisition/instruments/tdms_segments.hpp"

#include <Eigen/Core>

#include <filesystem>

namespace tapfit::acquisition {

/// Scales the values by the last of the channel's scales; leaves them as they
/// are where it has none or says that they are scaled.
///
/// @throws InputError for a scale of another kind, or one that is incomplete
void apply_tdms_scales(const TdmsObject& channel,
                       const std::filesystem::path& file,
                       Eigen::MatrixXd& values);

}  // namespace tapfit::acquisition
