#include "tui/views/frf_curves.hpp"

#include "signal/checks/confidence_band.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace tapfit::tui {

const char* unit_of(signal::FrfForm form) {
  if (form == signal::FrfForm::Receptance) return "m/N";
  return form == signal::FrfForm::Mobility ? "(m/s)/N" : accelerance_unit;
}

signal::FrfForm next(signal::FrfForm form) {
  using signal::FrfForm;
  if (form == FrfForm::Accelerance) return FrfForm::Mobility;
  return form == FrfForm::Mobility ? FrfForm::Receptance : FrfForm::Accelerance;
}

MagnitudeScale next(MagnitudeScale scale) {
  if (scale == MagnitudeScale::Logarithmic) return MagnitudeScale::Linear;
  return scale == MagnitudeScale::Linear ? MagnitudeScale::Decibels
                                         : MagnitudeScale::Logarithmic;
}

double decibels(double magnitude) { return 20.0 * std::log10(magnitude); }

// Nothing at all is no number of decibels, and leaves a gap.
Plot in_scale(Plot plot, MagnitudeScale scale) {
  plot.y.log = scale == MagnitudeScale::Logarithmic;
  if (scale != MagnitudeScale::Decibels) return plot;
  plot.y.unit = "dB re 1 " + plot.y.unit;
  for (Curve& curve : plot.curves) {
    for (Eigen::VectorXd* values : {&curve.y, &curve.low, &curve.high}) {
      *values = values->unaryExpr(&decibels);
    }
  }
  return plot;
}

Curve magnitude_curve(const std::string& label,
                      const Eigen::VectorXd& frequency_hz,
                      const Eigen::VectorXcd& H,
                      const Pen& pen) {
  Curve curve{label, {}, {}, {}, {}, pen};
  if (H.size() != frequency_hz.size()) return curve;
  curve.x = frequency_hz;
  curve.y = H.cwiseAbs();
  return curve;
}

Curve phase_curve(const std::string& label,
                  const Eigen::VectorXd& frequency_hz,
                  const Eigen::VectorXcd& H,
                  const Pen& pen) {
  Curve curve{label, {}, {}, {}, {}, pen};
  if (H.size() != frequency_hz.size()) return curve;
  curve.x = frequency_hz;
  curve.y.resize(H.size());
  double last = 0.0;
  for (Eigen::Index i = 0; i < H.size(); ++i) {
    const double phase = std::arg(H[i]) * 180.0 / std::numbers::pi;
    // A jump across the cut is no curve; leave out its first point.
    const bool jumped = i > 0 && std::abs(phase - last) > 270.0;
    curve.y[i] = jumped ? std::numeric_limits<double>::quiet_NaN() : phase;
    last = phase;
  }
  return curve;
}

Curve measured_curve(const std::string& label,
                     const Eigen::VectorXd& frequency_hz,
                     const signal::Frf& frf,
                     bool band) {
  Curve curve = magnitude_curve(label, frequency_hz, frf.H, {Colour::Sky});
  if (band && curve.y.size() > 0 && frf.variance.size() == curve.y.size()) {
    const Eigen::VectorXd reach = signal::confidence_reach(frf);
    curve.low = (curve.y - reach).cwiseMax(0.0);
    curve.high = curve.y + reach;
  }
  return curve;
}

FrequencySpan frequency_span(const signal::FrfSet& frfs) {
  if (frfs.lines() < 2) return {};
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (!(f[0] < f[f.size() - 1])) return {};
  return {f[0], f[f.size() - 1]};
}

double line_spacing(const signal::FrfSet& frfs) {
  if (frfs.lines() < 2) return 0.0;
  const FrequencySpan span = frequency_span(frfs);
  return (span.hi - span.lo) / static_cast<double>(frfs.lines() - 1);
}

Plot frf_plot(const signal::FrfSet& frfs,
              const PlotRange& range,
              signal::FrfForm form) {
  const FrequencySpan span = frequency_span(frfs);
  const PlotRange shown = resolved(range, span.lo, span.hi);
  Plot plot;
  plot.x = {"f", "Hz", shown.lo, shown.hi, false};
  plot.y = {"|H|", unit_of(form), 0.0, 0.0, false};
  if (shown.cursor_set) plot.cursor = shown.cursor;
  return plot;
}

Plot evidence_plot(const signal::FrfSet& frfs,
                   const updating::EffectEvidence& evidence,
                   const PlotRange& range) {
  const signal::Frf& frf = frfs.frfs[*evidence.frf];
  const Eigen::VectorXd f = frfs.frequency_hz();
  Plot plot = frf_plot(frfs, range);
  plot.title = signal::name(frf);
  plot.curves = {
      measured_curve("measured", f, frf, false),
      magnitude_curve(
          "without", f, evidence.without, {Colour::Grey, Pattern::Dotted, '.'}),
      magnitude_curve(
          "with", f, evidence.with, {Colour::Orange, Pattern::Dashed, 'o'})};
  return in_scale(std::move(plot), MagnitudeScale::Logarithmic);
}

}  // namespace tapfit::tui
