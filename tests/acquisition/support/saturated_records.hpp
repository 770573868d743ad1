// Blows of one tip and hand, maybe cut off by a conditioner that saturates
// ahead of the recorder's anti-alias filter. For tests and the study over
// seeds.
//
//   force -> cut at the ceiling -> anti-alias filter -> sampling -> noise ->
//   24 bits
#pragma once

#include "acquisition/foundation/seeded_random.hpp"
#include "acquisition/samples/anti_alias.hpp"
#include "tests/acquisition/support/butterworth.hpp"
#include "tests/acquisition/support/hammer_record.hpp"

#include <limits>
#include <string>
#include <vector>

namespace tapfit::testing {

using acquisition::SeededRandom;

enum class TipKind { HalfSine, Haversine, Skewed, Dented, TwoStage, Hertz };

struct BlowTip {
  TipKind kind = TipKind::HalfSine;
  double power = 1.0;   ///< skewed, dented: of the sine
  double skew = 1.0;    ///< sin(pi u^skew)
  double dent = 0.0;    ///< times 1 + dent cos(3 pi (u - 1/2))
  double stage = 1.0;   ///< two stages, Hertz: compression of the first one
  double second = 1.0;  ///< stiffness of the second stage, of the first
};

/// Everything that makes a record.
struct Blows {
  BlowTip tip;
  double rate = 4096.0;
  double width_s = 5e-3;  ///< of a blow of strength 1, foot to foot
  std::vector<double> strengths;
  double hertz = 0.1;           ///< width falls as strength^-hertz
  double width_scatter = 0.05;  ///< relative, from blow to blow
  double shape_scatter = 0.0;   ///< 1: skew by 4 %, dent by 0.03
  double noise = 1e-4;          ///< of the largest force
  double ceiling = std::numeric_limits<double>::infinity();
  bool causal = false;  ///< filter: Butterworth's, not one of linear phase
};

struct Saturated {
  acquisition::Recording recording;
  std::vector<double> errors;  ///< |H| too large by, per blow
};

inline constexpr int fast_per_sample = 16;

// A blow against a mass of 1 on a spring of 1 up to a stage, then of another
// stiffness; width is that of the linear one.
inline Eigen::VectorXd contact_force(const BlowTip& tip,
                                     double strength,
                                     double width,
                                     double part) {
  const double power = tip.kind == TipKind::Hertz ? 1.5 : 1.0;
  const double slope = power * std::pow(tip.stage, power - 1.0);
  const auto force = [&](double x) {
    const double first = std::clamp(x, 0.0, tip.stage);
    const double more = std::max(0.0, x - tip.stage);
    return std::pow(first, power) + tip.second * slope * more;
  };
  const double dt = std::numbers::pi / width;
  double v = strength;
  double x = v * dt * part;
  std::vector<double> values;
  while (x > 0.0 || values.empty()) {
    values.push_back(force(x));
    const double before = -force(x);
    x += v * dt + 0.5 * before * dt * dt;
    v += 0.5 * (before - force(x)) * dt;
  }
  return Eigen::VectorXd::Map(values.data(),
                              static_cast<Eigen::Index>(values.size()));
}

/// One blow's force, sampled `width` times from foot to foot.
///
/// @param part of a sample, from the foot to the first one
inline Eigen::VectorXd blow_force(const BlowTip& tip,
                                  double strength,
                                  double width,
                                  double part) {
  if (tip.kind == TipKind::TwoStage || tip.kind == TipKind::Hertz) {
    return contact_force(tip, strength, width, part);
  }
  Eigen::VectorXd force =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(std::ceil(width)) + 1);
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const double u = (static_cast<double>(i) + part) / width;
    if (u >= 1.0) break;
    const double sine = std::sin(std::numbers::pi * std::pow(u, tip.skew));
    const double dent =
        1.0 + tip.dent * std::cos(3.0 * std::numbers::pi * (u - 0.5));
    force[i] = strength * std::pow(std::max(sine, 0.0), tip.power) * dent;
  }
  return force;
}

/// From blow to blow, as deliberate ones are apart [s].
inline double gap_of(const Blows& blows) { return 0.6 + 1000.0 / blows.rate; }

/// Hammer and one response, which answers to the force that was there.
inline Saturated saturated(const Blows& blows, SeededRandom& random) {
  const double gap_s = gap_of(blows);
  const double number = static_cast<double>(blows.strengths.size());
  const auto n = static_cast<Eigen::Index>((number + 0.6) * gap_s * blows.rate);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd response = Eigen::VectorXd::Zero(n);
  Saturated result;
  constexpr Eigen::Index pad = 64 * fast_per_sample;
  for (std::size_t k = 0; k < blows.strengths.size(); ++k) {
    const double strength = blows.strengths[k];
    BlowTip tip = blows.tip;
    if (tip.kind == TipKind::Skewed) {
      tip.skew *= 1.0 + 0.04 * blows.shape_scatter * random.normal();
      tip.skew = std::min(tip.skew, 1.0);
    }
    if (tip.kind == TipKind::Dented) {
      tip.dent += 0.03 * blows.shape_scatter * random.normal();
    }
    const double width = blows.width_s * blows.rate * fast_per_sample *
                         std::pow(strength, -blows.hertz) *
                         random.scatter(blows.width_scatter);
    const Eigen::VectorXd whole =
        blow_force(tip, strength, width, random.uniform(0.0, 1.0));
    const Eigen::VectorXd cut = whole.cwiseMin(blows.ceiling);
    result.errors.push_back(whole.sum() / cut.sum() - 1.0);
    Eigen::VectorXd fast = Eigen::VectorXd::Zero(whole.size() + 2 * pad);
    fast.segment(pad, whole.size()) = cut;
    Eigen::VectorXd slow =
        blows.causal
            ? Eigen::VectorXd(
                  behind_butterworth(std::move(fast), fast_per_sample)(
                      Eigen::seq(0, Eigen::last, Eigen::fix<fast_per_sample>)))
            : Eigen::VectorXd(acquisition::decimate(fast, fast_per_sample));
    const double time_s =
        (0.6 + static_cast<double>(k)) * gap_s * random.scatter(0.01);
    const auto first = static_cast<Eigen::Index>(time_s * blows.rate);
    const Eigen::Index count = std::min(slow.size(), n - first);
    force.segment(first, count) += slow.head(count);
    const double impulse =
        whole.sum() / (blows.width_s * blows.rate * fast_per_sample);
    const auto room = static_cast<Eigen::Index>(gap_s * blows.rate);
    for (Eigen::Index i = 0; i < room && first + 64 + i < n; ++i) {
      const auto t = static_cast<double>(i);
      response[first + 64 + i] += impulse *
                                  std::exp(-10.0 * t / (gap_s * blows.rate)) *
                                  std::sin(0.1 * std::numbers::pi * t);
    }
  }
  result.recording.sample_rate_hz = blows.rate;
  result.recording.samples.resize(n, 2);
  Eigen::Index column = 0;
  for (Eigen::VectorXd* signal : {&force, &response}) {
    const double noise = blows.noise * signal->maxCoeff();
    for (double& value : *signal) {
      // The recorder's full scale is 500.
      value += noise * random.normal();
      value = 500.0 * 0x1p-23 * std::round(value / 500.0 * 0x1p23);
    }
    result.recording.samples.col(column++) = *signal;
  }
  return result;
}

/// Whether a warning speaks of a conditioner's ceiling.
inline bool tells_of_ceiling(const acquisition::HitSet& hits) {
  return std::ranges::any_of(hits.findings, [](const Finding& finding) {
    return in_full(finding).find("ahead of the recorder's filter") !=
           std::string::npos;
  });
}

/// A tip, hand, rate and noise of the whole range: 256 Hz to 51.2 kHz, blows
/// of 0.2 to 10 ms, five samples long or more; levels scatter by 5 to 60 %.
inline Blows any_blows(SeededRandom& random) {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform(0.0, 1.0));
  };
  Blows blows;
  do {
    blows.rate = between(256.0, 51200.0);
    blows.width_s = between(0.2e-3, 10e-3);
  } while (blows.width_s * blows.rate < 5.0);
  BlowTip& tip = blows.tip;
  tip.kind = static_cast<TipKind>(random.uniform(0.0, 6.0));
  if (tip.kind == TipKind::Haversine) tip.power = 2.0;
  if (tip.kind == TipKind::Skewed || tip.kind == TipKind::Dented) {
    tip.power = random.uniform(0.75, 2.0);
    tip.skew = random.uniform(0.7, 1.0);
  }
  if (tip.kind == TipKind::Dented) tip.dent = random.uniform(-0.15, 0.2);
  tip.second = between(0.15, 4.0);
  tip.stage = random.uniform(0.3, 1.2);
  const double scatter = between(0.05, 0.6);
  const int number = static_cast<int>(random.uniform(3.0, 16.0));
  for (int k = 0; k < number; ++k) {
    const double strength = std::exp(scatter * random.normal());
    blows.strengths.push_back(std::clamp(strength, 0.2, 5.0));
  }
  blows.hertz = random.uniform(0.0, 0.2);
  blows.width_scatter = random.uniform(0.0, 0.08);
  blows.shape_scatter = random.uniform(0.0, 2.0);
  blows.noise = between(1e-5, 1e-2);
  blows.causal = random.uniform(0.0, 1.0) < 0.3;
  return blows;
}

/// Lets the conditioner saturate where a blow of one of the strengths peaks,
/// whichever but the very weakest and strongest.
inline void saturate(Blows& blows, SeededRandom& random) {
  std::vector<double> sorted = blows.strengths;
  std::ranges::sort(sorted);
  const double share = random.uniform(0.2, 0.8);
  const auto k =
      static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  blows.ceiling = blow_force(blows.tip, sorted[k], 400.0, 0.3).maxCoeff();
  blows.noise = std::min(blows.noise, 3e-3);
}

}  // namespace tapfit::testing
