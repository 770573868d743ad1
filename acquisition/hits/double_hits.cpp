#include "acquisition/hits/double_hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Below the main pulse's low end a line has too little force, as of a blow that
// is too soft (ISO 7626-5).
constexpr double least_force_db = -20.0;
// Of the response; to 1 % sensors are calibrated at best (ISO 16063-21).
constexpr double most_outside = 0.01;

// Samples of the force without gaps: a pulse, or several that meet.
struct Stretch {
  Index from = 0;
  Eigen::VectorXd force;
};

std::vector<Stretch> stretches_of(const HammerSignal& hammer,
                                  std::vector<Pulse> pulses) {
  std::ranges::sort(pulses, {}, &Pulse::peak);
  std::vector<std::pair<Index, Index>> spans;
  for (const Pulse& pulse : pulses) {
    const auto reach =
        std::max<Index>(4, static_cast<Index>(std::ceil(1.5 * pulse.width)));
    const Index from = std::max<Index>(0, pulse.peak - reach);
    const Index to = std::min(hammer.force.size(), pulse.peak + reach + 1);
    if (spans.empty() || from > spans.back().second) {
      spans.emplace_back(from, to);
    } else {
      spans.back().second = std::max(spans.back().second, to);
    }
  }
  std::vector<Stretch> stretches;
  for (const auto& [from, to] : spans) {
    stretches.push_back({from, hammer.force.segment(from, to - from)});
  }
  return stretches;
}

// |sum of f_n exp(-j step n)| over all stretches.
double spectrum(const std::vector<Stretch>& stretches, double step) {
  const std::complex<double> turn = std::polar(1.0, -step);
  std::complex<double> all = 0.0;
  for (const Stretch& one : stretches) {
    std::complex<double> sum = 0.0;  // Horner's rule from the last sample on
    for (Index i = one.force.size(); i-- > 0;) sum = sum * turn + one.force[i];
    all += sum * std::polar(1.0, -step * static_cast<double>(one.from));
  }
  return std::abs(all);
}

double level_db(double value, double reference) {
  return 20.0 * std::log10(std::max(value, 1e-12) / std::max(reference, 1e-12));
}

// The least force in the band, below the main pulse's low end [dB].
struct LeastForce {
  double alone_db = 0.0;     ///< of the main pulse
  double together_db = 0.0;  ///< of all
};

LeastForce least_force(const HammerSignal& hammer,
                       const Pulse& main,
                       const std::vector<Pulse>& others,
                       const JudgedBlock& block) {
  std::vector<Pulse> pulses = others;
  pulses.push_back(main);
  const std::vector<Stretch> together = stretches_of(hammer, pulses);
  const std::vector<Stretch> alone = stretches_of(hammer, {main});
  const auto length =
      static_cast<double>(together.back().from + together.back().force.size() -
                          together.front().from);
  const double from = block.band_hz[0] / block.sample_rate_hz;
  const double width = block.band_hz[1] / block.sample_rate_hz - from;
  // Eight points to each of the dips, which are 1 / length apart; dips without
  // number are met at any phase.
  constexpr double most = 4096.0;
  const auto points =
      static_cast<int>(std::clamp(std::ceil(8.0 * width * length), 64.0, most));
  const double low = spectrum(alone, 0.0);
  LeastForce least;
  for (int k = 0; k <= points; ++k) {
    const double step = 2.0 * std::numbers::pi * (from + width * k / points);
    least.alone_db =
        std::min(least.alone_db, level_db(spectrum(alone, step), low));
    least.together_db =
        std::min(least.together_db, level_db(spectrum(together, step), low));
  }
  return least;
}

// What is left of a response after some samples.
double left_after(Index samples, const JudgedBlock& block) {
  if (block.decay.rate > 0.0) {
    const double seconds =
        static_cast<double>(std::max<Index>(0, samples)) / block.sample_rate_hz;
    return std::exp(-block.decay.rate * seconds);
  }
  return samples < block.decay.lasting ? 1.0 : 0.0;
}

std::string range_text(double low, double high, const char* unit) {
  const std::string to = fmt::format("{:.2g}", high);
  const std::string from = fmt::format("{:.2g}", low);
  return from == to ? fmt::format("{} {}", to, unit)
                    : fmt::format("{} to {} {}", from, to, unit);
}

struct Doubles {
  int count = 0;
  double least_share = 1e300;
  double most_share = 0.0;
  double least_after_s = 1e300;
  double most_after_s = 0.0;
  double loss_db = 0.0;
  double outside = 0.0;

  void add(const SecondPulse& second) {
    ++count;
    least_share = std::min(least_share, second.share);
    most_share = std::max(most_share, second.share);
    const double apart_s = std::abs(second.after_s);
    least_after_s = std::min(least_after_s, apart_s);
    most_after_s = std::max(most_after_s, apart_s);
    loss_db = std::max(loss_db, second.loss_db);
    outside = std::max(outside, second.outside);
  }

  [[nodiscard]] std::string text() const {
    return fmt::format(
        "{} of the main blow, {} from it",
        range_text(100.0 * least_share, 100.0 * most_share, "%"),
        range_text(1e3 * least_after_s, 1e3 * most_after_s, "ms"));
  }
};

}  // namespace

std::optional<SecondPulse> judge_second_pulses(const HammerSignal& hammer,
                                               const Pulse& main,
                                               const std::vector<Pulse>& others,
                                               const JudgedBlock& block) {
  if (others.empty()) return std::nullopt;
  const Pulse& largest = *std::ranges::max_element(others, {}, &Pulse::height);
  SecondPulse second;
  second.share = largest.height / main.height;
  second.after_s = (largest.centre - main.centre) / block.sample_rate_hz;

  const LeastForce least = least_force(hammer, main, others, block);
  constexpr double endless_db = 99.0;
  second.loss_db =
      std::clamp(least.alone_db - least.together_db, 0.0, endless_db);
  second.thins_force =
      least.together_db < least_force_db && least.alone_db >= least_force_db;

  double heights = main.height;
  Index last = main.peak;
  for (const Pulse& pulse : others) {
    heights += pulse.height;
    last = std::max(last, pulse.peak);
  }
  for (const Pulse& pulse : others) {
    second.outside +=
        pulse.height / heights * left_after(block.end - pulse.peak, block);
  }
  const double own =
      main.height / heights * left_after(block.end - main.peak, block);
  const Index first = std::min(main.peak, others.front().peak);
  const bool completed = last < first + (block.end - first) / 2;
  second.leaves_block =
      second.outside > most_outside && !(completed && own > most_outside);
  return second;
}

std::vector<std::string> double_statements(const HitSet& hits) {
  Doubles kept;
  Doubles thin;
  Doubles late;
  for (const std::vector<Hit>& run : hits.runs) {
    for (const Hit& hit : run) {
      const bool noted = std::ranges::count(hit.reasons, HitFault::Double) > 0;
      if (!noted || !hit.second) continue;
      if (hit.second->leaves_block) {
        late.add(*hit.second);
      } else if (hit.second->thins_force) {
        thin.add(*hit.second);
      } else {
        kept.add(*hit.second);
      }
    }
  }
  const auto hits_of = [](const Doubles& of) {
    return fmt::format("{} double hit{}", of.count, of.count == 1 ? "" : "s");
  };
  std::vector<std::string> statements;
  if (kept.count > 0) {
    statements.push_back(fmt::format(
        "{} {} not rejected for that: second blows ({}) are part of the force, "
        "take at most {:.1f} dB of it in the band and leave {:.2g} % of the "
        "response outside the block",
        hits_of(kept),
        kept.count == 1 ? "is" : "are",
        kept.text(),
        kept.loss_db,
        100.0 * kept.outside));
  }
  if (thin.count > 0) {
    statements.push_back(fmt::format(
        "{} {} too little force at some lines of the band: second blows ({}) "
        "take up to {:.0f} dB of it",
        hits_of(thin),
        thin.count == 1 ? "has" : "have",
        thin.text(),
        thin.loss_db));
  }
  if (late.count > 0) {
    statements.push_back(fmt::format(
        "{} {} the block too early: second blows ({}) leave up to {:.2g} % of "
        "the response outside it",
        hits_of(late),
        late.count == 1 ? "ends" : "end",
        late.text(),
        100.0 * late.outside));
  }
  return statements;
}

}  // namespace tapfit::acquisition
