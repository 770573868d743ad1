#include "acquisition/checks/steady_tones.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Samples = Eigen::Ref<const VectorXd>;
using complex = std::complex<double>;

constexpr Index fewest_samples = 128;

// Means of as many neighbours that no more than `most` remain.
VectorXd means(const Samples& x, Index most, Index& of_each) {
  of_each = (x.size() + most - 1) / most;
  VectorXd y(x.size() / of_each);
  for (Index i = 0; i < y.size(); ++i) {
    y(i) = x.segment(i * of_each, of_each).mean();
  }
  return y;
}

VectorXd without_slope(const VectorXd& x) {
  const VectorXd t = VectorXd::LinSpaced(x.size(), -1.0, 1.0);
  return x.array() - x.mean() - t.dot(x) / t.squaredNorm() * t.array();
}

// sum of x_n exp(-j turn n)
complex line_at(const Samples& x, double turn) {
  const complex step = std::polar(1.0, -turn);
  complex at = 1.0;
  complex sum = 0.0;
  for (const double value : x) {
    sum += value * at;
    at *= step;
  }
  return sum;
}

double amplitude_at(const Samples& x, double turn) {
  return 2.0 * std::abs(line_at(x, turn)) / static_cast<double>(x.size());
}

// The turn per sample between `low` and `high` at which the line is largest.
double largest_between(const VectorXd& x, double low, double high) {
  for (int i = 0; i < 30; ++i) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    if (std::abs(line_at(x, a)) < std::abs(line_at(x, b))) {
      low = a;
    } else {
      high = b;
    }
  }
  return 0.5 * (low + high);
}

/// Of one channel in one run.
struct Heard {
  std::size_t run = 0;
  std::size_t channel = 0;
  Tone tone;
  double share = 0.0;  // of the response
};

std::vector<Heard> heard_in(const TestBundle& bundle,
                            std::size_t run,
                            const Recording& recording,
                            const HitSet& hits,
                            const ToneLimits& limits) {
  std::vector<Heard> heard;
  if (hits.runs[run].empty() || recording.samples.rows() == 0) return heard;
  const Hit& first = hits.runs[run].front();
  const auto pulse =
      static_cast<Index>(std::ceil(2.0 * first.pulse_s * hits.sample_rate_hz));
  const Index quiet = first.trigger - pulse;
  if (quiet < fewest_samples) return heard;
  for (const Placement& sensor : bundle.runs[run].sensors) {
    const auto x = recording.samples.col(static_cast<Index>(sensor.channel));
    const auto tone =
        steady_tone(x.head(quiet), recording.sample_rate_hz, limits);
    if (!tone) continue;
    const VectorXd response = x.tail(x.size() - first.trigger);
    const double level =
        std::sqrt((response.array() - response.mean()).square().mean());
    if (level > 0.0 && tone->rms > limits.worth_saying * level) {
      heard.push_back({run, sensor.channel, *tone, tone->rms / level});
    }
  }
  return heard;
}

bool is_mains(const Tone& tone) {
  for (const double mains : {50.0, 60.0}) {
    const double order = std::max(std::round(tone.hz / mains), 1.0);
    if (std::abs(tone.hz - order * mains) < 0.5 * tone.resolution_hz) {
      return true;
    }
  }
  return false;
}

Finding tone_finding(const TestBundle& bundle,
                     const std::vector<Heard>& of_one) {
  std::set<std::size_t> runs;
  std::set<std::size_t> channels;
  for (const Heard& heard : of_one) {
    runs.insert(heard.run);
    channels.insert(heard.channel);
  }
  const Heard& most = *std::ranges::max_element(of_one, {}, &Heard::share);
  return {Severity::Warning,
          {{runs.begin(), runs.end()},
           channels.size() == 1 ? bundle.channels[most.channel].name
                                : std::string(),
           {},
           {}},
          fmt::format("a steady tone of {:.4g} Hz stands before the first blow "
                      "already, {:.2g} % of the response",
                      most.tone.hz,
                      100.0 * most.share),
          is_mains(most.tone)
              ? "mains hum: a ground loop, an unshielded cable or a supply"
              : "a machine that runs nearby, or hum",
          "FRFs mean nothing at that frequency: stop what makes it and measure "
          "these runs again"};
}

}  // namespace

std::optional<Tone> steady_tone(const Samples& samples,
                                double rate_hz,
                                const ToneLimits& limits) {
  if (samples.size() < fewest_samples) return {};
  Index of_each = 1;
  const VectorXd x =
      without_slope(means(samples, limits.most_samples, of_each));
  const Index lines = (x.size() - 1) / 2;
  const double line = 2.0 * std::numbers::pi / static_cast<double>(x.size());
  VectorXd power(lines);
  for (Index k = 0; k < lines; ++k) {
    power(k) = std::norm(line_at(x, line * static_cast<double>(k + 1)));
  }
  Index at = 0;
  const double largest = power.maxCoeff(&at);
  const double sum = power.sum();
  if (!(sum > 0.0)) return {};
  const auto count = static_cast<double>(lines);
  const double log_chance =
      std::log(count) +
      (count - 1.0) * std::log1p(-std::min(largest / sum, 1.0 - 1e-12));
  if (log_chance > std::log(limits.false_alarm)) return {};
  const auto periods = static_cast<double>(at + 1);
  if (periods < limits.fewest_periods) return {};
  const double turn =
      largest_between(x, line * (periods - 1.0), line * (periods + 1.0));
  const double before = amplitude_at(x.head(x.size() / 2), turn);
  const double after = amplitude_at(x.tail(x.size() / 2), turn);
  if (std::abs(before - after) > limits.steady * std::max(before, after)) {
    return {};
  }
  const double rate = rate_hz / static_cast<double>(of_each);
  return Tone{turn * rate / (2.0 * std::numbers::pi),
              amplitude_at(x, turn) / std::numbers::sqrt2,
              rate / static_cast<double>(x.size())};
}

std::vector<Finding> tone_findings(const TestBundle& bundle,
                                   const std::vector<Recording>& recordings,
                                   const HitSet& hits,
                                   const ToneLimits& limits) {
  std::vector<std::vector<Heard>> of(
      std::min(recordings.size(), hits.runs.size()));
  for_each_parallel(of.size(), [&](std::size_t r) {
    of[r] = heard_in(bundle, r, recordings[r], hits, limits);
  });
  std::vector<std::vector<Heard>> tones;
  for (const std::vector<Heard>& in_run : of) {
    for (const Heard& heard : in_run) {
      const auto same = std::ranges::find_if(tones, [&](const auto& tone) {
        return std::abs(tone.front().tone.hz - heard.tone.hz) <
               heard.tone.resolution_hz;
      });
      (same != tones.end() ? *same : tones.emplace_back()).push_back(heard);
    }
  }
  std::vector<Finding> findings;
  for (const std::vector<Heard>& tone : tones) {
    findings.push_back(tone_finding(bundle, tone));
  }
  return findings;
}

}  // namespace tapfit::acquisition
