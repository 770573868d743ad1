// Columns of samples out of a file, with what it says of them.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct TimeTable {
  Eigen::MatrixXd values;          ///< n_rows x columns
  std::vector<std::string> units;  ///< per column; empty where the file is mute
  std::optional<double> rate_hz;   ///< where the file says it
  /// How far rate_hz may be off, relative to it, where times gave it; empty
  /// where the file states it.
  std::optional<double> rate_spread;
  std::vector<std::string> notes = {};  ///< what was made of it, to be said
};

}  // namespace tapfit::acquisition
