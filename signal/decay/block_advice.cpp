#include "signal/decay/block_advice.hpp"

#include "acquisition/samples/octave_decay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

using acquisition::Hit;
using acquisition::HitSet;
using Eigen::Index;

// Whether and how a band leaves [low, high] out and keeps half its width. A
// factor of 1.5 is far enough from a resonance for what the end of the block
// makes of it.
std::optional<std::array<double, 2>> narrower(
    const DecayCheck& lasting, const std::array<double, 2>& band) {
  const double half = 0.5 * (band[1] - band[0]);
  const double from = 1.5 * lasting.high_hz;
  const double to = lasting.low_hz / 1.5;
  if (band[1] - from >= half) return std::array{from, band[1]};
  if (to - band[0] >= half) return std::array{band[0], to};
  return std::nullopt;
}

std::string proposal(const BlockAdvice& advice) {
  std::string text;
  if (advice.every_run) {
    text = fmt::format("a block of {:.3g} s (block_s; {} of {} hits have room)",
                       advice.block_s,
                       advice.with_room,
                       advice.accepted);
  } else {
    text = fmt::format(
        "a block of {:.3g} s, for which this recording has no room (at most "
        "{:.3g} s): wait longer between blows",
        advice.block_s,
        advice.room_s);
  }
  if (!advice.band_hz) return text;
  return text + fmt::format(", or a band of {:.4g} to {:.4g} Hz",
                            (*advice.band_hz)[0],
                            (*advice.band_hz)[1]);
}

}  // namespace

std::optional<BlockAdvice> advise_block(const DecayCheck& lasting,
                                        const HitSet& hits,
                                        const std::vector<Index>& samples,
                                        const std::array<double, 2>& band_hz) {
  if (!lasting.any()) return std::nullopt;
  const double rate = hits.sample_rate_hz;
  const double pre_s = static_cast<double>(hits.pre_trigger) / rate;
  BlockAdvice advice;
  advice.lasting = lasting;
  advice.block_s = pre_s + acquisition::decayed_time_constants / lasting.rate;
  // Rates of decay are no better known.
  constexpr double as_good = 1.05;
  const double block_s = static_cast<double>(hits.block) / rate;
  if (advice.block_s < as_good * block_s) return std::nullopt;
  advice.band_hz = narrower(lasting, band_hz);
  advice.every_run = true;
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    const std::vector<Hit>& run = hits.runs[r];
    int accepted = 0;
    int with_room = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (!run[k].accepted) continue;
      const Index end = k + 1 < run.size() ? run[k + 1].trigger : samples.at(r);
      const double room_s =
          pre_s + static_cast<double>(end - run[k].trigger) / rate;
      ++accepted;
      with_room += room_s >= advice.block_s ? 1 : 0;
      advice.room_s = std::max(advice.room_s, room_s);
    }
    advice.accepted += accepted;
    advice.with_room += with_room;
    advice.every_run = advice.every_run && (accepted == 0 || with_room > 0);
  }
  return advice;
}

std::string statement(const BlockAdvice& advice, double sigma) {
  const DecayCheck& lasting = advice.lasting;
  std::string text = fmt::format(
      "the response at {:.4g} Hz has not decayed at the end of the block "
      "({:.2g} "
      "time constants, 6 are needed); before any window, take {}",
      lasting.hz,
      lasting.time_constants,
      proposal(advice));
  if (!(sigma > 0.0)) return text;
  return text +
         fmt::format(
             ". With this block the exponential window widens resonances by "
             "{:.2g} Hz and adds {:.2g} % to the damping ratio there; that is "
             "taken off again, but close modes may not come apart",
             sigma / std::numbers::pi,
             100.0 * sigma / (2.0 * std::numbers::pi * lasting.hz));
}

std::string hum_statement(const DecayCheck& lasting) {
  if (lasting.hum_hz == 0.0) return {};
  return fmt::format(
      "{:.4g} Hz does not decay: mains hum or a very light mode; check the "
      "pre-trigger signal",
      lasting.hum_hz);
}

std::string excited_statement(const DecayCheck& lasting) {
  const Excited& excited = lasting.excited;
  if (excited.hz == 0.0) return {};
  const std::string when =
      excited.after_s > 0.0
          ? fmt::format("decays for {:.3g} s after the blow and is then",
                        excited.after_s)
          : std::string("does not decay after the blow: it is");
  return fmt::format(
      "the response at {:.4g} Hz {} excited by something else (wind, machines, "
      "people), which a longer block does not take away: measure when it is "
      "quiet, hit harder or more often",
      excited.hz,
      when);
}

std::vector<std::string> lasting_statements(
    const DecayCheck& lasting,
    const HitSet& hits,
    const std::vector<Index>& samples,
    const std::array<double, 2>& band_hz,
    double sigma) {
  std::vector<std::string> said;
  if (const auto advice = advise_block(lasting, hits, samples, band_hz)) {
    said.push_back(statement(*advice, sigma));
  }
  for (const std::string& more :
       {hum_statement(lasting), excited_statement(lasting)}) {
    if (!more.empty()) said.push_back(more);
  }
  return said;
}

}  // namespace tapfit::signal
