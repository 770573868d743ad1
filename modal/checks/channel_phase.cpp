#include "modal/checks/channel_phase.hpp"

#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using complex = std::complex<double>;

/// Of one channel, per mode: sum of z^2 over its FRFs, each FRF counted by its
/// own size, and of |z|^2.
struct Squares {
  VectorXcd z2;
  VectorXd size;
};

Squares squares_of(const signal::FrfSet& set,
                   const std::vector<ModalConstants>& of,
                   std::size_t channel,
                   Index modes) {
  Squares sums{VectorXcd::Zero(modes), VectorXd::Zero(modes)};
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    if (set.frfs[f].channel != channel) continue;
    for (Index k = 0; k < modes; ++k) {
      const double size = std::norm(of[f].z(k));
      // Noise of the size of z has no phase.
      if (size < 100.0 * std::pow(of[f].sd(k), 2)) continue;
      sums.z2(k) += of[f].z(k) * of[f].z(k);
      sums.size(k) += size;
    }
  }
  return sums;
}

// Mean sin^2 of the phases once these angles are taken off, over modes that
// show.
double left_by_angles(const Squares& sums, const VectorXd& angles) {
  double sum = 0.0;
  int count = 0;
  for (Index k = 0; k < angles.size(); ++k) {
    if (!(sums.size(k) > 0.0)) continue;
    const complex back = std::polar(1.0, -2.0 * angles(k));
    sum += 0.5 * (1.0 - (sums.z2(k) * back).real() / sums.size(k));
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double left_with(const Squares& sums, const VectorXd& w, double delay) {
  return left_by_angles(sums, -delay * w);
}

// The delay of least sin^2, within half a period of the highest mode.
double best_delay(const Squares& sums, const VectorXd& w) {
  constexpr int steps = 400;
  const double most = std::numbers::pi / w.maxCoeff();
  double best = 0.0;
  double least = left_with(sums, w, 0.0);
  for (int i = -steps; i <= steps; ++i) {
    const double delay = most * i / steps;
    const double left = left_with(sums, w, delay);
    if (left >= least) continue;
    least = left;
    best = delay;
  }
  // Newton's step on the smooth minimum.
  const double h = 0.1 * most / steps;
  for (int i = 0; i < 5; ++i) {
    const double up = left_with(sums, w, best + h);
    const double down = left_with(sums, w, best - h);
    const double bend = up + down - 2.0 * left_with(sums, w, best);
    if (!(bend > 0.0)) break;
    best -= 0.5 * h * (up - down) / bend;
  }
  return best;
}

VectorXd filter_angles(const VectorXd& w, double corner, bool high_pass) {
  return w.unaryExpr([&](double at) {
    return high_pass ? std::atan(corner / at) : -std::atan(at / corner);
  });
}

// The corner of least sin^2: by steps of its logarithm, then by halving them.
PhaseFilter best_filter(const Squares& sums,
                        const VectorXd& w,
                        bool high_pass) {
  constexpr double beyond = 30.0;  // of the modes: a turn of two degrees
  constexpr int steps = 100;
  constexpr int halvings = 12;
  double step = std::log(beyond * beyond * w.maxCoeff() / w.minCoeff()) / steps;
  const auto left_at = [&](double corner) {
    return left_by_angles(sums, filter_angles(w, corner, high_pass));
  };
  double best = w.minCoeff() / beyond;
  double least = left_at(best);
  for (int i = 1; i <= steps; ++i) {
    const double corner = w.minCoeff() / beyond * std::exp(i * step);
    const double left = left_at(corner);
    if (left >= least) continue;
    least = left;
    best = corner;
  }
  for (int i = 0; i < halvings; ++i) {
    step *= 0.5;
    for (const double corner : {best * std::exp(step), best / std::exp(step)}) {
      const double left = left_at(corner);
      if (left >= least) continue;
      least = left;
      best = corner;
    }
  }
  PhaseFilter filter;
  filter.high_pass = high_pass;
  filter.corner_hz = best / (2.0 * std::numbers::pi);
  filter.left = least;
  // d angle / d ln w_c = x / (1 + x^2), x = w_c / w, for either.
  double slopes = 0.0;
  double shown = 0.0;
  const VectorXd angles = filter_angles(w, best, high_pass);
  for (Index k = 0; k < w.size(); ++k) {
    if (!(sums.size(k) > 0.0)) continue;
    const double x = best / w(k);
    slopes += std::pow(x / (1.0 + x * x), 2);
    filter.turn = std::max(filter.turn, std::abs(angles(k)));
    ++shown;
  }
  const double variance = least * shown / (shown - 1.0);
  filter.corner_sd_hz = filter.corner_hz * std::sqrt(variance / slopes);
  return filter;
}

ChannelPhase phase_of(std::size_t channel,
                      const Squares& sums,
                      const VectorXd& w,
                      const ChannelPhaseLimits& limits) {
  ChannelPhase phase;
  phase.channel = channel;
  phase.turned = left_with(sums, w, 0.0);
  phase.with_delay = phase.turned;
  const Index shown = (sums.size.array() > 0.0).count();
  if (shown < limits.fewest_modes) return phase;
  phase.delay_s = best_delay(sums, w);
  phase.with_delay = left_with(sums, w, phase.delay_s);
  // sin^2 is the squared angle left: its mean over the freedom is the variance
  // of one mode's angle.
  const double variance = phase.with_delay * static_cast<double>(shown) /
                          static_cast<double>(shown - 1);
  double ww = 0.0;
  for (Index k = 0; k < w.size(); ++k) {
    if (sums.size(k) > 0.0) ww += w(k) * w(k);
  }
  phase.delay_sd = std::sqrt(variance / ww);
  if (!(w.minCoeff() > 0.0)) return phase;  // a mode that does not swing
  const PhaseFilter high = best_filter(sums, w, true);
  const PhaseFilter low = best_filter(sums, w, false);
  phase.filter = high.left < low.left ? high : low;
  return phase;
}

bool is_delayed(const ChannelPhase& phase,
                double highest,
                const ChannelPhaseLimits& limits) {
  return std::abs(phase.delay_s) * highest > limits.slight_phase &&
         std::abs(phase.delay_s) > limits.significance * phase.delay_sd &&
         phase.with_delay < limits.explained * phase.turned;
}

bool is_filtered(const ChannelPhase& phase, const ChannelPhaseLimits& limits) {
  if (!phase.filter) return false;
  const PhaseFilter& filter = *phase.filter;
  return filter.turn > limits.slight_phase &&
         filter.corner_hz > limits.significance * filter.corner_sd_hz &&
         filter.left < limits.explained * phase.turned &&
         filter.left < limits.rather_filter * phase.with_delay;
}

Finding velocity_finding(const std::string& channel, double turned) {
  return {Severity::Error,
          {{}, channel, {}, {}},
          fmt::format("its resonances are turned by 90 degrees ({:.0f} % of "
                      "their power)",
                      100.0 * turned),
          "the channel measures velocity, not acceleration (or its signal was "
          "integrated or differentiated once)",
          fmt::format("give {} \"quantity\": \"velocity\" and its unit in "
                      "test.json",
                      channel)};
}

Finding delay_finding(const std::string& channel,
                      const ChannelPhase& phase,
                      double highest) {
  const double angle = std::abs(phase.delay_s) * highest;
  return {angle > 2.0 * ChannelPhaseLimits{}.slight_phase ? Severity::Warning
                                                          : Severity::Note,
          {{}, channel, {}, {}},
          fmt::format("its phase grows with frequency: it comes {:.3g} ms "
                      "(sd {:.1g}) {} the hammer, {:.2g} degrees at the "
                      "highest mode",
                      1e3 * std::abs(phase.delay_s),
                      1e3 * phase.delay_sd,
                      phase.delay_s > 0.0 ? "behind" : "before",
                      angle * 180.0 / std::numbers::pi),
          "filters or converters that differ between the channels",
          "give both channels the same anti-alias filter and converter; the "
          "diagnosis takes it in as channel-delay"};
}

Finding filter_finding(const std::string& channel, const PhaseFilter& filter) {
  const bool high = filter.high_pass;
  return {
      filter.turn > 2.0 * ChannelPhaseLimits{}.slight_phase ? Severity::Warning
                                                            : Severity::Note,
      {{}, channel, {}, {}},
      fmt::format("its modes are turned as behind a {}-pass filter with its "
                  "corner at {:.3g} Hz (sd {:.1g}), the {} by {:.2g} "
                  "degrees",
                  high ? "high" : "low",
                  filter.corner_hz,
                  filter.corner_sd_hz,
                  high ? "lowest" : "highest",
                  filter.turn * 180.0 / std::numbers::pi),
      high ? "AC coupling, or a short time constant of the amplifier"
           : "an analogue filter, or a long cable",
      fmt::format("give the channel and the hammer the same {}, and measure "
                  "again: the {} modes come out too small",
                  high ? "coupling" : "filter",
                  high ? "lowest" : "highest")};
}

VectorXd damped_frequencies(const ModeSet& modes) {
  return poles_of(modes).imag();
}

}  // namespace

std::vector<ChannelPhase> channel_phases(const signal::FrfSet& set,
                                         const ModeSet& modes,
                                         const ChannelPhaseLimits& limits) {
  if (modes.modes.empty()) return {};
  const VectorXcd poles = poles_of(modes);
  const std::vector<ModalConstants> of = modal_constants(set, poles, false);
  std::set<std::size_t> channels;
  for (const signal::Frf& frf : set.frfs) channels.insert(frf.channel);
  std::vector<ChannelPhase> phases;
  for (const std::size_t channel : channels) {
    const Squares sums = squares_of(set, of, channel, poles.size());
    if (!(sums.size.maxCoeff() > 0.0)) continue;
    phases.push_back(phase_of(channel, sums, poles.imag(), limits));
  }
  return phases;
}

std::vector<Finding> channel_phase_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes,
    const ChannelPhaseLimits& limits) {
  if (modes.modes.empty() || bundle.runs.empty()) return {};
  const double highest = damped_frequencies(modes).maxCoeff();
  std::vector<Finding> findings;
  for (const ChannelPhase& phase : channel_phases(set, modes, limits)) {
    const std::string& channel = bundle.channels.at(phase.channel).name;
    if (phase.turned > limits.imaginary) {
      findings.push_back(velocity_finding(channel, phase.turned));
    } else if (is_filtered(phase, limits)) {
      findings.push_back(filter_finding(channel, *phase.filter));
    } else if (is_delayed(phase, highest, limits)) {
      findings.push_back(delay_finding(channel, phase, highest));
    }
  }
  return findings;
}

}  // namespace tapfit::modal
