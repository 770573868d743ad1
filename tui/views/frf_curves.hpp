// FRFs as curves for plots.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/plot.hpp"
#include "tui/widgets/plot_range.hpp"

#include <Eigen/Core>

#include <string>

namespace tapfit::tui {

inline constexpr const char* accelerance_unit = "(m/s²)/N";

/// @param frequency_hz one per line of H
/// @param H accelerance [(m/s^2)/N]; a length other than the frequencies'
///   gives an empty curve
[[nodiscard]] Curve magnitude_curve(const std::string& label,
                                    const Eigen::VectorXd& frequency_hz,
                                    const Eigen::VectorXcd& H,
                                    const Pen& pen);

/// -180 .. 180 degrees; jumps at the cut leave a gap.
[[nodiscard]] Curve phase_curve(const std::string& label,
                                const Eigen::VectorXd& frequency_hz,
                                const Eigen::VectorXcd& H,
                                const Pen& pen);

/// |H| with |H| -+ 1.96 sd around it.
[[nodiscard]] Curve measured_curve(const std::string& label,
                                   const Eigen::VectorXd& frequency_hz,
                                   const signal::Frf& frf,
                                   bool band);

/// First and last frequency; {0, 1} without lines.
struct FrequencySpan {
  double lo = 0.0;
  double hi = 1.0;
};
[[nodiscard]] FrequencySpan frequency_span(const signal::FrfSet& frfs);

/// Distance between neighbouring lines, 0 with fewer than two.
[[nodiscard]] double line_spacing(const signal::FrfSet& frfs);

/// An empty magnitude plot over the range's stretch, with its cursor.
[[nodiscard]] Plot frf_plot(const signal::FrfSet& frfs,
                            const PlotRange& range,
                            bool log);

}  // namespace tapfit::tui
