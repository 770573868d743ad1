// How the engineer wants the parameters identified.
#pragma once

#include "updating/residual/line_rule.hpp"

#include <optional>

namespace tapfit::updating {

struct UpdateChoice {
  LineRule lines;
  bool l_curve = false;          ///< lambda at the L-curve's corner
  std::optional<double> lambda;  ///< or this one
  /// Whether the plain step is asked for, and not the default with its prior.
  [[nodiscard]] bool is_plain() const {
    return lines.kind != LineKind::Damped || l_curve || lambda.has_value();
  }
};

}  // namespace tapfit::updating
