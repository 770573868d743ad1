// A curve in the frame of a plot as an SVG path: what lies above or below the
// frame is cut off at its edge, not drawn along it.
#pragma once

#include "tui/widgets/drawing.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace tapfit::tui {

/// One axis, from values to pixels.
class Scale {
 public:
  Scale(const Axis& axis, double at_low, double at_high);

  /// Empty for what is not finite, or not positive on a logarithmic axis.
  [[nodiscard]] std::optional<double> operator()(double value) const;

 private:
  [[nodiscard]] double shown(double value) const;

  bool log_;
  double low_, high_, at_low_, at_high_;
};

/// Edges in pixels.
struct Frame {
  double left, top, right, bottom;
};

/// Points joined, from gap to gap; of each pixel column the lowest and the
/// highest.
/// @param y as x
[[nodiscard]] std::string line_path(const Frame& frame,
                                    const Scale& to_x,
                                    const Scale& to_y,
                                    const Eigen::VectorXd& x,
                                    const Eigen::VectorXd& y);

/// A dot for each point that lies in the frame.
[[nodiscard]] std::string dotted_path(const Frame& frame,
                                      const Scale& to_x,
                                      const Scale& to_y,
                                      const Eigen::VectorXd& x,
                                      const Eigen::VectorXd& y);

}  // namespace tapfit::tui
