// Numbers out of MATLAB files, by way of matio (included only here).
#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Reads variables as columns of samples. A name may go on with ".field" for
/// structures and end with ":k" for the k-th column (row, where those are
/// longer) of a matrix.
///
/// @return n_samples x names.size()
/// @throws InputError for a file that is none, a name that is not there (and
///   which ones are), a variable that is no real number or has another length
[[nodiscard]] Eigen::MatrixXd read_mat_columns(
    const std::filesystem::path& file, const std::vector<std::string>& names);

/// A variable of one value.
[[nodiscard]] double read_mat_number(const std::filesystem::path& file,
                                     const std::string& name);

/// The version of matio that is in use.
[[nodiscard]] std::string matlab_library();

}  // namespace tapfit::acquisition
