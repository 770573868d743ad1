// One channel of a recording, with all that its file says of it.
#pragma once

#include "acquisition/foundation/dof.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace tapfit::acquisition {

struct TimeRecord {
  std::string
      column;        ///< what names it in its file: "Signal.y_values.values:2"
  std::string name;  ///< as the file calls the channel; never empty
  std::string unit;  ///< of the values; empty where the file is mute
  /// The sensitivity that the recorder has divided by [V per unit].
  std::optional<double> volts_per_unit = {};
  std::optional<Dof> dof = {};  ///< where it was, if the file says it
  std::optional<double> rate_hz = {};
  /// How far rate_hz may be off, relative to it, where times gave it.
  std::optional<double> rate_spread = {};
  Eigen::VectorXd values = {};
};

}  // namespace tapfit::acquisition
