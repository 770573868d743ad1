// FRFs as curves for plots.
#pragma once

#include "signal/frf_set/convert.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/plot.hpp"
#include "tui/widgets/plot_range.hpp"
#include "updating/comparison/effect_evidence.hpp"

#include <Eigen/Core>

#include <string>

namespace tapfit::tui {

[[nodiscard]] const char* unit_of(signal::FrfForm form);

inline constexpr const char* accelerance_unit = "(m/s²)/N";

/// Accelerance, mobility, receptance, and round again.
[[nodiscard]] signal::FrfForm next(signal::FrfForm form);

/// How magnitudes are drawn.
enum class MagnitudeScale { Logarithmic, Linear, Decibels };
[[nodiscard]] MagnitudeScale next(MagnitudeScale scale);

/// Of one magnitude.
[[nodiscard]] double decibels(double magnitude);

/// A plot of magnitudes in that scale: 20 log10 |H| for decibels.
[[nodiscard]] Plot in_scale(Plot plot, MagnitudeScale scale);

/// @param frequency_hz one per line of H
/// @param H a length other than the frequencies' gives an empty curve
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

/// An empty plot of magnitudes over the range's stretch, with its cursor.
[[nodiscard]] Plot frf_plot(
    const signal::FrfSet& frfs,
    const PlotRange& range,
    signal::FrfForm form = signal::FrfForm::Accelerance);

/// Of the FRF where an effect shows most: measured, and of the model without
/// and with it.
/// @pre evidence.frf is one of the FRFs
[[nodiscard]] Plot evidence_plot(const signal::FrfSet& frfs,
                                 const updating::EffectEvidence& evidence,
                                 const PlotRange& range);

}  // namespace tapfit::tui
