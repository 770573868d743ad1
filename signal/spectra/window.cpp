#include "signal/spectra/window.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

// Rising half of a cosine taper: row i of n, 0 < value < 1.
double taper_value(Eigen::Index i, Eigen::Index n) {
  return 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i + 1) /
                              static_cast<double>(n + 1));
}

}  // namespace

PulseSpan find_pulse(const Eigen::Ref<const Eigen::VectorXd>& force,
                     Eigen::Index trigger,
                     Eigen::Index pulse_samples,
                     double noise_rms) {
  const Eigen::Index block = force.size();
  const Eigen::Index width = std::max<Eigen::Index>(pulse_samples, 2);
  const Eigen::Index reach =
      std::min(block - 1, trigger + std::max(block / 10, 4 * width));
  Eigen::Index peak = trigger;
  for (Eigen::Index i = trigger; i <= std::min(reach, trigger + 2 * width); ++i)
    if (std::abs(force(i)) > std::abs(force(peak))) peak = i;
  const double direction = force(peak) < 0.0 ? -1.0 : 1.0;
  // Below 2e-4 of the peak a bounce changes the force spectrum by less than
  // the sensor's own linearity.
  const double level = std::max(6.0 * noise_rms, 2e-4 * std::abs(force(peak)));
  PulseSpan span{trigger, trigger + 1};
  for (Eigen::Index i = 0; i <= reach; ++i) {
    if (direction * force(i) <= level) continue;
    // Forward a bounce may come late; backward only the pulse's own rise
    // (with a filter's ringing) is looked for.
    if (i < trigger - 8 * width) continue;
    span.begin = std::min(span.begin, i);
    span.end = std::max(span.end, i + 1);
  }
  span.begin = std::max<Eigen::Index>(0, span.begin - width);
  span.end = std::min(block, span.end + width);
  return span;
}

void apply_pulse_window(const PulseSpan& span,
                        Eigen::Index taper,
                        Eigen::Ref<Eigen::VectorXd> block) {
  apply_causal_window(span, taper, block);
  const Eigen::Index fades = std::min(taper, block.size() - span.end);
  for (Eigen::Index i = 0; i < fades; ++i) {
    block(span.end + i) *= taper_value(taper - 1 - i, taper);
  }
  block.tail(block.size() - span.end - fades).setZero();
}

void apply_causal_window(const PulseSpan& span,
                         Eigen::Index taper,
                         Eigen::Ref<Eigen::VectorXd> block) {
  const Eigen::Index first = std::max<Eigen::Index>(0, span.begin - taper);
  block.head(first).setZero();
  for (Eigen::Index row = first; row < span.begin; ++row) {
    block(row) *= taper_value(row - (span.begin - taper), taper);
  }
}

Eigen::VectorXd exponential_window(Eigen::Index block,
                                   Eigen::Index trigger,
                                   double dt,
                                   double sigma) {
  const Eigen::ArrayXd t =
      dt *
      (Eigen::ArrayXd::LinSpaced(block, 0.0, static_cast<double>(block - 1)) -
       static_cast<double>(trigger));
  return (-sigma * t).exp().matrix();
}

double decay_rate(double end_value, double seconds) {
  if (!(end_value > 0.0 && end_value <= 1.0))
    throw InputError(
        fmt::format("an exponential window cannot end at {}", end_value),
        "window end value",
        "give a value above 0 and up to 1, for example 0.01");
  return -std::log(end_value) / seconds;
}

}  // namespace tapfit::signal
